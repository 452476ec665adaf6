"""Completions in names of rings: ``QQ_5``, ``QQ(I)_(5, I-2)``, ``QQ[s]/(s^3-2)_inf0``, ``GF(3)(t)_t``."""

import re
from fractions import Fraction
from functools import cache

import sympy

from tests.adversary.names.arithmetic import (
    QQ,
    Galois,
    Poly,
    common,
    factors_modulo,
    irreducible,
    monic,
    negative,
    plus,
    real_roots,
    remainder,
    times,
)
from tests.adversary.names.expressions import Unsure, names_in, parsed, refuse, worked_out
from tests.adversary.names.numbers import Data, X, generator, matched, modulus_of

INFINITY = ("inf", "oo", "∞", "infinity", "infty")
NUMBER_FIELDS = ("number field", "root field", "cyclotomic field", "real cyclotomic field")


def completion(field: Data, text: str) -> Data:
    """Return the completion of a global field at the place of a text."""
    bare = not (text.startswith("(") and text.endswith(")") and matched(text[1:-1]))
    inside = text if bare else text[1:-1]
    kind = field["kind"]
    if kind == "rationals":
        return {"kind": "reals"} if inside.lower() in INFINITY else p_adic(inside)
    if kind == "rational functions":
        return _of_functions(field, inside, bare)
    if bare and "," in text:
        refuse("brackets around p and an element")
    if kind == "quadratic field":
        return _of_quadratic(field, inside)
    if kind in NUMBER_FIELDS:
        return _of_number_field(field, inside)
    if kind in ("multiquadratic field", "field of numbers"):
        raise Unsure("places of fields of several numbers")
    refuse("no global field")


def at(field: Data, place: Data) -> Data:
    """Return a completion of its data."""
    return {"kind": "completion", "of": field, "place": place}


def p_adic(text: str) -> Data:
    """Return ℚ_p."""
    return at({"kind": "rationals"}, {"kind": "number", "n": _prime(text)})


def _prime(text: str) -> int:
    if not re.fullmatch("[0-9]+", text) or not sympy.isprime(int(text)):
        refuse("no prime")
    return int(text)


def galois_field(data: Data) -> Galois:
    """Return a finite field of its data."""
    if data["degree"] == 1:
        return Galois(data["characteristic"])
    if data["modulus"] is None:
        raise Unsure("the modulus of a large field")
    return Galois(data["characteristic"], tuple(data["modulus"]))


def _of_functions(field: Data, text: str, bare: bool) -> Data:
    base, (variable, *others) = field["base"], field["variables"]
    if others or base["kind"] != "finite field":
        refuse("the residue field is infinite")
    if text.lower() in INFINITY and (bare or text != variable):
        return at(field, {"kind": "infinity"})
    K = galois_field(base)
    names = {"x": (K.x,)} if K.degree > 1 else {}
    f = worked_out(parsed(text), {**names, variable: (K.zero, K.one)}, K)
    if not irreducible(K, f):
        refuse("no prime polynomial")
    digits = [list(c) if K.degree > 1 else c[0] for c in monic(K, f)]
    return at(field, {"kind": "prime polynomial", "coefficients": digits})


def _of_quadratic(field: Data, text: str) -> Data:
    d = field["d"]
    if text in ("inf+", "inf-") and d > 0:
        return {"kind": "reals"} if text == "inf+" else at(field, {"kind": "real", "number": 0})
    if text == "inf" and d < 0:
        return {"kind": "complexes"}
    first, comma, rest = text.partition(",")
    p = _prime(first)
    splits = d % 8 == 1 if p == 2 else d % p and pow(d, (p - 1) // 2, p) == 1
    if not comma:
        return refuse("two primes") if splits else at(field, {"kind": "number", "n": p})
    m = re.fullmatch(rf"{re.escape(generator(field))}-([0-9]+)", rest)
    r = int(m[1]) if m else 0
    fits = r in (1, 3) if p == 2 else 0 < r < p and (r * r - d) % p == 0
    if not splits or not fits:
        refuse("no such root")
    return at(field, {"kind": "split", "n": p, "root": r})


def _of_number_field(field: Data, text: str) -> Data:
    f = modulus_of(field)
    if text.startswith("inf"):
        real = len(real_roots(f))
        count = real + (len(f) - 1 - real) // 2
        names = ["inf"] if count == 1 else [f"inf{n}" for n in range(count)]
        if text not in names:
            refuse("no such place")
        number = names.index(text)
        return at(field, {"kind": "real" if number < real else "complex", "number": number})
    first, comma, rest = text.partition(",")
    p = _prime(first)
    if not regular(f, p):
        raise Unsure("the primes above a number that divides the index")
    factors = [g for g, _ in factors_modulo(f, p)]
    if comma:
        x = _element(rest, field, f)
        K = Galois(p)
        low = plus(K, tuple(K.number(c) for c in x), ())
        factors = [g for g in factors if not remainder(K, low, tuple((c,) for c in g))]
    if len(factors) != 1:
        refuse("no single place")
    return at(field, prime_ideal(f, p, factors[0]))


def _element(text: str, field: Data, f: Poly) -> Poly:
    """Read an element with whole coefficients."""
    name = generator(field)
    also = f"cbrt({field['radicand']})" if field.get("order") == 3 and "radicand" in field else name
    for word in (name, also):
        text = re.sub(rf"(?<![A-Za-z0-9_]){re.escape(word)}(?![A-Za-z0-9_(])", "@", text)
    if re.search(r"sqrt|root\(|cbrt", text):
        raise Unsure("other roots in the field")
    if "y" in text:
        refuse("an unknown name")
    tree = parsed(text.replace("@", "y"))
    x = worked_out(tree, {"y": X} if names_in(tree) else {}, QQ, f)
    return x if all(c.denominator == 1 for c in x) else refuse("whole coefficients")


def prime_ideal(f: Poly, p: int, factor: tuple[int, ...]) -> Data:
    """Return the ideal of p and a factor of f modulo p, p alone where f is irreducible there."""
    whole = len(factor) == len(f)
    element = None if whole else [*factor, *[0] * (len(f) - 1 - len(factor))]
    return {"kind": "prime ideal", "p": p, "element": element}


@cache
def regular(f: Poly, p: int) -> bool:
    """Dedekind: tell whether f is integral at p and ℤ[s] maximal there, s a root of f."""
    if any(c.denominator % p == 0 for c in f):
        return False
    K, whole = Galois(p), (QQ.one,)
    for g, e in factors_modulo(f, p):
        for _ in range(e):
            whole = times(QQ, whole, tuple(map(Fraction, g)))
    difference = plus(QQ, f, negative(QQ, whole))
    rest = plus(K, tuple(K.number(c / p) for c in difference), ())
    return all(
        e == 1 or len(common(K, tuple((c,) for c in g), rest)) == 1 for g, e in factors_modulo(f, p)
    )
