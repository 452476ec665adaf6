"""The command starts at once: ``--version`` and ``--help`` import nothing heavy."""

import subprocess
import sys

import pytest

from tests.patience import PATIENCE

HEAVY = ("sympy", "galois", "numpy", "matplotlib", "flint", "numba", "IPython")
# Of ours: what Python itself imports differs by version.
MAX_MODULES = {"--version": 16, "--help": 16, "prove": 150}

PROBE = """
import sys
from hfield.cli import main
{extra}
assert main([{word!r}]) == 0
print([name for name in {heavy!r} if name in sys.modules], file=sys.stderr)
"""


def imported(word, extra=""):
    """Return what a fresh process has imported after ``hfield WORD``."""
    code = PROBE.format(word=word, extra=extra, heavy=HEAVY)
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, timeout=PATIENCE
    )
    assert done.returncode == 0, done.stderr
    return done.stderr.strip()


@pytest.mark.parametrize("word", ["--version", "--help"])
def test_nothing_heavy_is_imported(word):
    assert imported(word) == "[]"


@pytest.mark.slow
def test_the_probe_can_fail():
    assert imported("--version", "import numpy") == "['numpy']"


@pytest.mark.slow
@pytest.mark.parametrize("words", [["--version"], ["--help"], ["prove", "(p*q)*r == p*(q*r)"]])
def test_few_modules_are_imported(words):
    code = (
        "import sys; from hfield.cli import main; assert main(sys.argv[1:]) == 0; "
        "print(sum(name.startswith('hfield') for name in sys.modules), file=sys.stderr)"
    )
    done = subprocess.run([sys.executable, "-c", code, *words], capture_output=True, text=True)
    assert int(done.stderr) < MAX_MODULES[words[0]]


@pytest.mark.slow
@pytest.mark.parametrize("command", [["eval", "i*j"], ["table", "--field", "GF9"]])
def test_finite_fields_and_rationals_need_no_sympy_nor_galois(command):
    code = (
        "import sys; from hfield.cli import main; assert main(sys.argv[1:]) == 0; "
        "assert not {'sympy', 'galois', 'matplotlib'} & set(sys.modules)"
    )
    subprocess.run([sys.executable, "-c", code, *command], check=True, timeout=PATIENCE)
