"""Data of rings and places, made directly, of every kind that the checker knows; and data near to others."""

import copy
from fractions import Fraction
from random import Random
from typing import Any

from tests.adversary.names.arithmetic import (
    Galois,
    factors_modulo,
    irreducible,
    irreducible_over_rationals,
    real_roots,
    squarefree_kernel,
)
from tests.adversary.names.composed import PRIMES, TAME, WILD
from tests.adversary.names.expressions import Refused
from tests.adversary.names.numbers import Data, modulus_of, number_data, principal
from tests.adversary.names.places import at, galois_field, prime_ideal, regular
from tests.adversary.names.reader import _conway, _variables

VARIABLES = [v for v in (*TAME, *WILD) if v.isascii()]


def data(rng: Random) -> Data:
    """Return data of a ring."""
    return rng.choice(KINDS)(rng)


def variable(base: Data, rng: Random, *, also: tuple[str, ...] = ()) -> str:
    """Return the name of a variable, odd ones as often as plain ones."""
    while True:
        name = rng.choice(TAME if rng.random() < 0.5 else VARIABLES)
        try:
            if name not in also:
                return _variables(name, base)[0]
        except Refused:
            continue


def plain(rng: Random) -> Data:
    """A ring without parts."""
    return {"kind": rng.choice(("rationals", "integers", "reals", "complexes", "floats"))}


def residues(rng: Random) -> Data:
    """ℤ/n."""
    return {
        "kind": "residues",
        "modulus": rng.choice((rng.randrange(2, 500), rng.randrange(2, 10**12))),
    }


def finite(rng: Random) -> Data:
    """GF(q), with Conway's modulus or another, or, where q is large, none."""
    p = rng.choice(PRIMES)
    n = rng.choice((1, 1, 2, 2, 3, 4, 5))
    field: Data = {"kind": "finite field", "characteristic": p, "degree": n, "modulus": None}
    if n == 1:
        return field
    if p**n > 4096 and rng.random() < 0.5:
        return field
    if p**n <= 4096 and rng.random() < 0.5:
        field["modulus"] = list(_conway(p, n))
        return field
    while True:
        f = [rng.randrange(p) for _ in range(n)] + [1]
        if irreducible(Galois(p), tuple((c,) for c in f)) and (p**n <= 4096 or f != _conway(p, n)):
            field["modulus"] = f
            return field


def quadratic(rng: Random) -> Data:
    """ℚ(√d)."""
    d = squarefree_kernel(rng.choice((rng.randrange(-60, 60), rng.randrange(-(10**6), 10**6))) or 2)
    return {"kind": "quadratic field", "d": d if d != 1 else -1}


def multiquadratic(rng: Random) -> Data:
    """ℚ(√m, √n, …), √−1 last."""
    pool = [n for n in range(-12, 40) if n not in (-1, 0, 1, 4, 9, 16, 25, 36)]
    d = rng.sample(pool, rng.choice((2, 2, 3)))
    return {"kind": "multiquadratic field", "d": d + ([-1] if rng.random() < 0.3 else [])}


def number_field(rng: Random) -> Data:
    """ℚ[s]/(f)."""
    while True:
        n = rng.choice((2, 2, 3, 3, 4, 5, 6))
        f = [Fraction(rng.randrange(-9, 10), rng.choice((1, 1, 1, 1, 2, 3))) for _ in range(n)]
        if irreducible_over_rationals((*f, Fraction(1))):
            modulus = [*map(number_data, f), 1]
            return {"kind": "number field", "modulus": modulus, "variable": variable({}, rng)}


def root_field(rng: Random) -> Data:
    """ℚ(ⁿ√a), of degree n."""
    while True:
        a = Fraction(rng.randrange(-30, 31) or 2, rng.choice((1, 1, 1, 2, 3, 5)))
        n = rng.choice((3, 3, 4, 5, 6, 7))
        if len(principal(a, n)) == n + 1:
            return {"kind": "root field", "radicand": number_data(a), "order": n}


def cyclotomic(rng: Random) -> Data:
    """ℚ(ζₙ), or what is real in it."""
    if rng.random() < 0.5:
        return {"kind": "cyclotomic field", "order": rng.randrange(3, 30)}
    orders = [n for n in range(5, 30) if n != 6]
    return {"kind": "real cyclotomic field", "order": rng.choice(orders)}


def functions(rng: Random) -> Data:
    """F(t)."""
    base = rng.choice(({"kind": "rationals"}, finite(rng), finite(rng)))
    return {"kind": "rational functions", "base": base, "variables": [variable(base, rng)]}


def polynomials(rng: Random) -> Data:
    """R[x, …]."""
    prime = {
        "kind": "finite field",
        "characteristic": rng.choice(PRIMES),
        "degree": 1,
        "modulus": None,
    }
    base: Data = rng.choice(({"kind": "rationals"}, {"kind": "integers"}, prime))
    names: list[str] = []
    for _ in range(rng.choice((1, 1, 2, 3))):
        names.append(variable(base, rng, also=(*names, "zeta5", "zeta_8", "zeta12")))
    return {"kind": "polynomials", "base": base, "variables": names}


def completion(rng: Random) -> Data:
    """A completion of a global field at a place."""
    return rng.choice(
        (_of_rationals, _of_quadratic, _of_number_field, _of_number_field, _of_functions)
    )(rng)


def _of_rationals(rng: Random) -> Data:
    return at({"kind": "rationals"}, {"kind": "number", "n": rng.choice((*PRIMES, 10**9 + 7))})


def _of_quadratic(rng: Random) -> Data:
    field = quadratic(rng)
    d, p = field["d"], rng.choice(PRIMES)
    if d > 0 and rng.random() < 0.2:
        return at(field, {"kind": "real", "number": 0})
    roots = (
        [r for r in range(p) if d % p and (r * r - d) % p == 0] if p > 2 else [1, 3] * (d % 8 == 1)
    )
    if not roots:
        return at(field, {"kind": "number", "n": p})
    return at(field, {"kind": "split", "n": p, "root": rng.choice(roots)})


def _of_number_field(rng: Random) -> Data:
    while True:
        field = rng.choice((number_field, root_field, cyclotomic))(rng)
        f, p = modulus_of(field), rng.choice(PRIMES)
        real = len(real_roots(f)) if len(f) < 9 else 0
        if real and rng.random() < 0.25 and len(f) > 3:
            return at(field, {"kind": "real", "number": rng.randrange(real)})
        if regular(f, p):
            factor = rng.choice(factors_modulo(f, p))[0]
            return at(field, prime_ideal(f, p, factor))


def _of_functions(rng: Random) -> Data:
    while True:
        field = functions(rng)
        base = field["base"]
        if base["kind"] == "rationals" or (base["degree"] > 1 and base["modulus"] is None):
            continue
        if rng.random() < 0.2:
            return at(field, {"kind": "infinity"})
        K = galois_field(base)
        n = rng.choice((1, 1, 2, 2, 3))
        f = tuple(tuple(rng.randrange(K.p) for _ in range(K.degree)) for _ in range(n))
        if rng.random() < 0.2:
            f = (K.zero,)
        if irreducible(K, (*f, K.one)):
            digits = [list(c) if K.degree > 1 else c[0] for c in (*f, K.one)]
            return at(field, {"kind": "prime polynomial", "coefficients": digits})


KINDS = (
    *(residues, finite, finite, quadratic, multiquadratic, number_field, number_field, root_field),
    *(
        cyclotomic,
        functions,
        functions,
        polynomials,
        polynomials,
        completion,
        completion,
        completion,
    ),
    *(completion, completion, plain),
)


# --- near others ---------------------------------------------------------------------------------


def near(data: Data, rng: Random) -> Data:
    """Return data that are like others but for one entry, or another kind of the same look."""
    out = copy.deepcopy(data)
    if rng.random() < 0.3:
        return _lookalike(out, rng)
    paths = [path for path in _paths(out) if path[-1] != "kind"] or [("kind",)]
    *above, last = rng.choice(paths)
    inside: Any = out
    for key in above:
        inside = inside[key]
    inside[last] = _changed(inside[last], rng)
    return out


def _paths(value: Any, path: tuple[Any, ...] = ()) -> list[tuple[Any, ...]]:
    entries = value.items() if isinstance(value, dict) else enumerate(value)
    found = []
    for key, x in entries:
        found += _paths(x, (*path, key)) if isinstance(x, (dict, list)) else [(*path, key)]
    return found


def _changed(x: Any, rng: Random) -> Any:
    if isinstance(x, bool) or x is None:
        return rng.choice((0, [0, 1], "", [1, 1, 1]))
    if isinstance(x, int):
        return rng.choice(
            (x + 1, x - 1, -x, 4 * x, str(x), f"{x}/1", f"{x}/2", f"{2 * x}/2", float(x), True)
        )
    if rng.random() < 0.5:
        return rng.choice(VARIABLES)
    return rng.choice(
        (f"{x}_", f"{x}1", f" {x}", f"({x})", f"{x},y", f"{x})(t", x.upper(), f"-{x}", x + "\n")
    )


def _lookalike(data: Data, rng: Random) -> Data:
    """Another ring that a name might be thought to mean."""
    kind = data["kind"]
    if kind == "completion":
        place, field = data["place"], data["of"]
        other: Data = rng.choice(
            ({"kind": "infinity"}, {"kind": "real", "number": 0}, {"kind": "number", "n": 5})
        )
        if field["kind"] == "rational functions" and place["kind"] == "infinity":
            one: Any = 1
            degree = field["base"]["degree"]
            other = {"kind": "prime polynomial", "coefficients": [0, 1]}
            if degree > 1:
                one = [1, *[0] * (degree - 1)]
                other["coefficients"] = [[0] * degree, one]
        return rng.choice((at(field, other), field, at(_lookalike(field, rng), place)))
    if kind == "rational functions":
        return {**data, "kind": "polynomials"}
    if kind == "polynomials":
        return {**data, "kind": "rational functions"}
    if kind == "finite field" and data["degree"] == 1:
        return {"kind": "residues", "modulus": data["characteristic"]}
    if kind == "finite field":
        return {**data, "modulus": None}
    if kind == "residues":
        return {
            "kind": "finite field",
            "characteristic": data["modulus"],
            "degree": 1,
            "modulus": None,
        }
    if kind == "quadratic field":
        modulus = [-data["d"], 0, 1]
        field = {"kind": "number field", "modulus": modulus, "variable": "s"}
        return rng.choice(
            (field, {"kind": "multiquadratic field", "d": [data["d"], 4 * data["d"]]})
        )
    if kind in ("cyclotomic field", "real cyclotomic field"):
        name = f"{'c' if kind[0] == 'r' else 'zeta'}{data['order']}"
        modulus = [number_data(c) for c in modulus_of(data)]
        functions: Data = {"base": {"kind": "rationals"}, "variables": [name]}
        return rng.choice(
            (
                {"kind": "number field", "modulus": modulus, "variable": name},
                {"kind": "rational functions", **functions},
                {"kind": "polynomials", **functions},
                {"kind": "cyclotomic field", "order": 2 * data["order"]},
            )
        )
    if kind == "root field":
        modulus = [number_data(-Fraction(data["radicand"])), *[0] * (data["order"] - 1), 1]
        return {"kind": "number field", "modulus": modulus, "variable": "s"}
    if kind == "number field":
        return {
            "kind": "rational functions",
            "base": {"kind": "rationals"},
            "variables": [data["variable"]],
        }
    return plain(rng)
