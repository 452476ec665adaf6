"""Heavy libraries are imported only by the rings that need them, and only when they do."""

import subprocess
import sys

import pytest

HEAVY = ("sympy", "galois", "numpy", "matplotlib", "numba")

CASES = {
    "import hfield.fields": (),
    "from hfield import ring; [ring(s) for s in ('QQ', 'GF(9)', 'RR', 'QQ(sqrt(2))', 'QQ(x)', "
    "'GF(4)(t)', 'ZZ[a,b]', 'CC', 'RDF', 'ZZ/6')]": (),
    "from hfield import ring; F = ring('GF(9)'); F.text(F('x+1') * F.inverse(F.gen)); F.level": (),
    "from hfield.fields import RR; x = RR('sqrt(2)/(1+sqrt(3))'); hash(x); RR.sign(x); RR.text(x); "
    "RR.sqrt(RR('3+2*sqrt(2)')); RR.names(); RR(RR.names()['pi'])": (),
    "from hfield import ring; F = ring('QQ(sqrt(-7))'); F.level; F.sqrt(F(-7)); F('1/2')": (),
    "from hfield.fields import RR; RR('root(2,3)')": ("sympy",),
    "from hfield.fields import GF; GF(7).array([1])": ("galois", "numpy"),
    "from hfield.fields import QQ; QQ.array([1])": ("numpy",),
}


@pytest.mark.slow
@pytest.mark.parametrize("code", CASES, ids=lambda code: code[-40:])
def test_imports(code):
    script = f"{code}\nimport sys\nprint(*[m for m in {HEAVY} if m in sys.modules])"
    done = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, check=True
    )
    loaded = set(done.stdout.split()) - {"numba"}
    assert set(CASES[code]) <= loaded
    assert loaded <= set(CASES[code]) | ({"sympy", "numpy"} if CASES[code] else set())
