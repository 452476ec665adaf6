"""Recompute products and symbols in Sage: python3 scripts/vectors/check_sage.py

Needs the PyPI package passagemath-schemes (Sage in wheels; 10.8.13 was used) in an environment of
its own. Sage's QuaternionAlgebra(K, c, b) wants a field of characteristic not 2 and c, b != 0;
t is completed away: i = t/2 + i' with i'^2 = c = a + t^2/4, and k = ij = (t/2)j + i'j.
Rings without division are checked in their field of fractions. Other cases are skipped.
"""

import re
from collections.abc import Callable
from typing import Any

from common import read_cases
from rings import RINGS, Ring
from sage.algebras.quatalg.quaternion_algebra import QuaternionAlgebra
from sage.all__sagemath_schemes import GF, QQ, PolynomialRing, QuadraticField
from sage.arith.misc import hilbert_symbol


def field(ring: Ring) -> tuple[Any, dict[str, Any]] | None:
    """Return the fraction field and the values of the names in the texts; None where 2 = 0."""
    name = ring.name
    if ring.modulus and ring.gp.find("Mod(1, 3)") > 0:
        x = PolynomialRing(GF(3), "x").gen()
        modulus = sum(c * x**n for n, c in enumerate(ring.modulus))
        K = GF(3 ** modulus.degree(), "x", modulus=modulus)
        return K, {"x": K.gen()}
    if prime := re.fullmatch(r"GF\((3|7|13)\)", name):
        return GF(int(prime[1])), {}
    if ring.root:
        d = -1 if ring.root == "I" else int(ring.root[5:-1])
        K = QuadraticField(d, "s")
        return K, {"s": K.gen()}
    if name in ("QQ", "ZZ"):
        return QQ, {}
    known = {"QQ(x)": (QQ, "x"), "GF(5)(t)": (GF(5), "t"), "ZZ[x,y]": (QQ, "x,y")}
    if name in known:
        base, names = known[name]
        K = PolynomialRing(base, names).fraction_field()
        return K, dict(zip(names.split(","), K.gens(), strict=True))
    return None


def element(text: str, K: Any, names: dict[str, Any], root: str) -> Any:
    """Read a text in K; every integer but an exponent is made an element of K first."""
    text = text.replace(root, "s") if root else text
    text = re.sub(r"(?<![\^\d])\d+", r"K(\g<0>)", text).replace("^", "**")
    return K(eval(text, {"K": K, **names}))


def agrees(case: dict[str, Any], K: Any, read: Callable[[str], Any]) -> bool | None:
    a, b, t = (read(case[name]) for name in ("a", "b", "t"))
    c = a + t * t / 4
    if c == 0 or b == 0:
        return None
    A = QuaternionAlgebra(K, c, b)
    i, j, _ = A.gens()
    i += t / 2

    def quaternion(texts: list[str]) -> Any:
        w, x, y, z = map(read, texts)
        return A(w) + x * i + y * j + z * (i * j)

    p, q = quaternion(case["p"]), quaternion(case["q"])
    inverse = case["inverse_p"]
    return bool(
        p * q == quaternion(case["product"])
        and p.conjugate() == quaternion(case["conj_p"])
        and p.reduced_norm() == read(case["norm_p"])
        and p.reduced_trace() == read(case["trace_p"])
        and (inverse is None or ~p == quaternion(inverse))
    )


def check_products() -> None:
    everything = read_cases("products.json")
    total = [0, 0]
    for ring in RINGS:
        found = field(ring)
        if found is None:
            continue
        K, names = found
        read = lambda text: element(text, K, names, ring.root)  # noqa: E731, B023
        results = [agrees(case, K, read) for case in everything if case["ring"] == ring.name]
        good, done = results.count(True), len(results) - results.count(None)
        total = [total[0] + good, total[1] + done]
        print(f"{ring.name}: {good} of {done} agree, {results.count(None)} skipped")
    print(f"products, all: {total[0]} of {total[1]} agree")


def check_ramification() -> None:
    cases = read_cases("ramification.json")
    good = 0
    for case in cases:
        algebra = QuaternionAlgebra(QQ, case["a"], case["b"])
        primes = [p for p in case["ramified"] if p != "inf"]
        same = algebra.discriminant() == case["discriminant"]
        same = same and algebra.ramified_primes() == primes
        good += bool(same and algebra.is_division_algebra() == case["division"])
    print(f"ramification: {good} of {len(cases)} agree")


def check_hilbert() -> None:
    """Compare with Sage's own symbol (algorithm="direct"), not the one that calls PARI."""
    cases = read_cases("hilbert.json")
    good = 0
    for case in cases:
        a, b = QQ(case["a"]), QQ(case["b"])
        place = -1 if case["place"] == "inf" else case["place"]
        good += hilbert_symbol(a, b, place, algorithm="direct") == case["value"]
    print(f"hilbert: {good} of {len(cases)} agree")


def check_quadratic() -> None:
    cases = read_cases("quadratic_division.json")
    good = 0
    for case in cases:
        K = QuadraticField(case["d"], "s")
        root = "I" if case["d"] == -1 else f"sqrt({case['d']})"
        a, b = (element(case[name], K, {"s": K.gen()}, root) for name in "ab")
        good += QuaternionAlgebra(K, a, b).is_division_algebra() == case["division"]
    print(f"quadratic division: {good} of {len(cases)} agree")


if __name__ == "__main__":
    check_products()
    check_ramification()
    check_hilbert()
    check_quadratic()
