"""Rings asked of PARI by their data: which of −1, 2, 3, 5 are squares, real places, residue fields."""

from fractions import Fraction
from functools import cache
from random import Random
from typing import Any

import pytest

from tests.adversary.names.facts import ASKED
from tests.adversary.names.numbers import Data, modulus_of


@cache
def pari() -> Any:
    """Return PARI; the test is skipped where it is not installed."""
    found = pytest.importorskip("cypari", reason="cypari is not installed (extra 'oracles')").pari
    found.allocatemem(10**9, silent=True)
    return found


def _polynomial(f: Any, variable: str = "y") -> str:
    return "+".join(f"({c})*{variable}^{n}" for n, c in enumerate(f))


def _integral(field: Data) -> tuple[str, int]:
    """Return the polynomial of m·s in y, and an m that makes it integral."""
    f, m = modulus_of(field), 1
    degree = len(f) - 1
    while any(c * m ** (degree - n) % 1 for n, c in enumerate(f)):
        m += 1
    return _polynomial([c * m ** (degree - n) for n, c in enumerate(f)]), m


def squares(data: Data) -> tuple[bool, ...]:
    """Tell which of the numbers asked for are squares in a field."""
    kind, P = data["kind"], pari()
    if kind == "rationals":
        return tuple(bool(P(f"issquare({n})")) for n in ASKED)
    if kind == "finite field":
        p, f = data["characteristic"], data["modulus"]
        q = f"Mod(1,{p})*({_polynomial(f, 'x')})" if f else f"{p}^{data['degree']}"
        one = f"ffgen({q})^0"
        return tuple(bool(P(f"issquare(({n})*{one})")) for n in ASKED)
    if kind == "rational functions":
        return squares(data["base"])
    if kind == "completion":
        return _local_squares(data["of"], data["place"])
    if kind == "multiquadratic field":
        f = P("y")
        for d in data["d"]:
            f = P(f"subst(polcompositum(subst({f},y,x), x^2-({d}))[1], x, y)")
    else:
        f, _ = _integral(data)
    return tuple(bool(P(f"#nfroots({f}, x^2-({n}))")) for n in ASKED)


def _local_squares(field: Data, place: Data) -> tuple[bool, ...]:
    """Squares in ℝ; in ℚ_p by precision; in F_q((π)) as in F_q; in K_v by many Hilbert symbols."""
    P = pari()
    if place["kind"] == "real":
        return tuple(n > 0 for n in ASKED)
    if field["kind"] == "rationals":
        return tuple(bool(P(f"issquare({n}+O({place['n']}^20))")) for n in ASKED)
    if field["kind"] == "rational functions":
        p, n = field["base"]["characteristic"], field["base"]["degree"]
        n *= len(place["coefficients"]) - 1 if "coefficients" in place else 1
        return tuple(bool(P(f"issquare(({m})*ffgen(ffinit({p},{n}))^0)")) for m in ASKED)
    nf, ideal = _ideal(field, place)
    rng, size = Random(1), len(modulus_of(field)) - 1
    drawn = [P(_polynomial([1 + rng.randrange(50) for _ in range(size)])) for _ in range(30)]
    elements = [*drawn, *(nf.nfeltmul(ideal[1], x) for x in drawn)]
    return tuple(all(nf.nfhilbert(n, c, ideal) == 1 for c in elements) for n in ASKED)


def _ideal(field: Data, place: Data) -> tuple[Any, Any]:
    """Return the field of PARI, and the prime ideal that contains what the data say."""
    P = pari()
    f, m = _integral(field)
    nf = P(f"nfinit({f})")
    p = place.get("p") or place["n"]
    if place["kind"] == "split":
        x = P(f"(y-({place['root']}))/{1 + (p == 2)}")
    else:
        x = P(_polynomial([Fraction(c) / m**n for n, c in enumerate(place.get("element") or [p])]))
    (found,) = (v for v in nf.idealprimedec(p) if int(nf.idealval(x, v)) > 0)
    return nf, found


def residues(data: Data) -> int:
    """Count the residue field at a prime ideal."""
    _, ideal = _ideal(data["of"], data["place"])
    return int(ideal[0]) ** int(ideal[3])


def real_places(field: Data) -> int:
    """Count the real places of a number field."""
    return int(pari()(f"polsturm({_integral(field)[0]})"))
