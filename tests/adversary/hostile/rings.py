"""Dear data of rings and of places, one of each kind and more."""

from collections.abc import Callable
from functools import partial
from math import comb, gcd
from typing import Any

from hfield.checker.scalars.finite import is_prime
from tests.adversary.hostile.writing import (
    IDENTITY,
    LONG,
    Hostile,
    certificate,
    fact_about_norms,
    joined,
    name_of,
    number,
    proved,
    ratio,
)
from tests.checker.ring_data import (
    INFINITY,
    QQ,
    ZZ,
    Data,
    completion,
    cyclotomic,
    finite,
    functions,
    generated,
    ideal,
    multiquadratic,
    other,
    polynomials,
    prime,
    quadratic,
    real,
    residues,
    root_field,
    split,
)
from tests.checker.ring_data import number as at_number

PRIME = 3317044064679887385961813  # just below the bound of what is proved prime
PRIMES = [n for n in range(10**9 - 1_500, 10**9) if is_prime(n)]
PRIME_41 = 3317044064679887385960581, 2477412767341923122420114  # and a root of X⁴¹ − 1 modulo it
GF_64 = finite(2, 64, [1, 1, 0, 1, 1, *[0] * 59, 1])
GF_193 = finite(193, 64, [(comb(64, k) - 5 * (k == 0)) % 193 for k in range(65)])  # (x + 1)⁶⁴ − 5
GF_LONG = finite(PRIME, 6, [(comb(6, k) - 2 * (k == 0)) % PRIME for k in range(7)])
MANY = [f"{a}{b}" for a in "abcdefgh" for b in range(8)]
DENSE = 0x8A20958E3175EE764EC75339FC4F7ACD0AEA6C871B11B34AE9  # irreducible of degree 199 over GF(2)


def named(data: Data) -> str:
    """A ring whose data are dear to read."""
    return proved("s == s", IDENTITY, data)


def at_place(data: Data, place: Data, value: str, times: int = 1) -> str:
    """Facts about norms at a place."""
    name = name_of(data)
    return fact_about_norms(
        [
            {"by": "place", "place": place, "u": [value, value, "0", "0"],
             "j": ["0", "0", value, "0"], "algebra": f"(-1,-{k}|{name})"}
            for k in range(2, 2 + min(times, 32))
        ],
        data,
    )  # fmt: skip


# --- number fields --------------------------------------------------------------------------------


def fraction(top: int, below: int) -> Any:
    """Return a number as data."""
    common = gcd(top, below)
    top, below = top // common, below // common
    return top if below == 1 else f"{top}/{below}"


def modulo_two(coefficient: Callable[[int], tuple[int, int]], n: int = 40) -> Data:
    """ℚ[g]/(f), f ≡ g⁴⁰ + g⁵ + g⁴ + g³ + 1 modulo 2, which is irreducible, with long coefficients."""
    f = []
    for k in range(n):
        top, below = coefficient(k)
        f.append(fraction(2 * top + (k in (0, 3, 4, 5)), 2 * below + 1))
    return generated([*f, 1], "g")


def long_modulus(n: int) -> Data:
    """The least common denominator of the coefficients is long."""
    return modulo_two(lambda k: (number(n, k), number(n, k + 50)))


def long_integers(n: int) -> Data:
    return modulo_two(lambda k: (number(n, k), 0))


def equal_denominators(n: int) -> Data:
    """Coefficients over powers of one number, so that ℤ[s] has far longer ones."""
    return modulo_two(lambda k: (1, (3 ** (n * (k + 1) // 40) - 1) // 2))


def close_roots(n: int) -> Data:
    """Two real roots of X⁴⁰ − 7·(aX − 1)² are as close as a to the power −21 (Mignotte)."""
    a = 13 * number(n) + 1  # irreducible modulo 13
    return generated([-7, 14 * a, -7 * a * a, *[0] * 37, 1], "g")


def ordered(data: Data, value: str, times: int = 1) -> str:
    """Signs at all real roots."""
    name = name_of(data)
    facts = [
        {"by": "ordering", "algebra": f"({value}-{k},-1|{name})"}
        for k in range(1, 1 + min(times, 32))
    ]
    return fact_about_norms(facts, data, "g")


def moved_cyclotomic(n: int) -> Data:
    """Φ₂₁(X − c), reducible modulo every prime: discs are found around its roots, close to one another."""
    f, c = [1, -1, 0, 1, -1, 0, 1, 0, -1, 1, 0, -1, 1], 2**n
    moved = [
        sum(a * comb(k, m) * (-c) ** (k - m) for k, a in enumerate(f) if k >= m) for m in range(13)
    ]
    return generated(moved, "g")


def generator_modulo_83(theta: list[int]) -> Data:
    """The ideal of 83 and ζ₄₁ − 30, in terms of another generator."""
    return other(83, [-sum(c * 30**k for k, c in enumerate(theta)), 1], theta)


def long_element(n: int) -> str:
    """The ideal of 83 and of an element that is ζ₄₁ − 30 modulo 83."""
    element = [-30, 1, *[0] * 38]
    long = [c + 83 * number(n, k) for k, c in enumerate(element)]
    return at_place(cyclotomic(41), ideal(83, *long), "zeta41")


# --- functions, and rings in rings ----------------------------------------------------------------


def prime_polynomial(base: Data, n: int) -> Data:
    """A polynomial of degree n over GF(q), t^n + x·t + x, or what is near it; not always a prime."""
    size = base["degree"]
    if size == 1:
        return prime(*(DENSE >> k & 1 for k in range(n)), 1)
    x, one, none = ([int(m == k) for m in range(size)] for k in (1, 0, size))
    return prime(x, x, *[none] * (n - 2), one)


def nested(n: int) -> Data:
    """Completions of completions."""
    data = QQ
    for _ in range(n):
        data = completion(data, real(0))
    return data


def nested_functions(n: int) -> Data:
    data = QQ
    for k in range(n):
        data = functions(data, f"x{k}")
    return data


def specialised(n: int) -> str:
    top = joined(f"{number(20, k)}*x**{k}" for k in range(min(n, 18)))
    reason = {"by": "specialisation", "at": ratio(10 * n), "proof": {"by": "ordering"}}
    facts = [{"algebra": f"(-({top})**{n // 20 + 1},-1|QQ(x))", **reason}]
    return fact_about_norms(facts, functions(QQ, "x"), "x")


# --- the rings that statements name -----------------------------------------------------------------


def circles(n: int) -> Data:
    """Functions of the cosines and sines of n angles and of n variables, over a large finite field."""
    angles = [[f"t{k}", k + 1] for k in range(n)]
    return {
        "kind": "circle functions", "base": GF_193, "angles": angles, "variables": MANY[:n],
    }  # fmt: skip


def many_rings(data: Callable[[int], Data], n: int) -> str:
    """A statement about n rings, the data of all of which are read."""
    rings = [data(k) for k in range(n)]
    parts = [f"over{{{name_of(ring)}; s == s}}" for ring in rings]
    inside = {"kind": "parts", "parts": [{"verdict": "proved", "evidence": IDENTITY}] * n}
    evidence = {"kind": "rings", "rings": rings, "evidence": inside}
    return certificate(f"every{{{'; '.join(parts)}}}", evidence, method="identity")


def other_rings(data: Callable[[int], Data], n: int) -> str:
    """The data of n rings, and a statement that names none of these."""
    evidence = {"kind": "rings", "rings": [data(k) for k in range(n)], "evidence": IDENTITY}
    return certificate("over{QQ; s == s}", evidence)


def rings_in_rings(n: int) -> str:
    """Each of the rings inside the other."""
    rings = [residues(number(LONG // 2, k)) for k in range(n)]
    text = "s == s"
    for ring in rings:
        text = f"over{{{name_of(ring)}; {text}}}"
    return certificate(text, {"kind": "rings", "rings": rings, "evidence": IDENTITY})


ORDERS = [n for n in range(7, 400) if sum(gcd(m, n) == 1 for m in range(n)) <= 40]

FILES: dict[str, Hostile] = {
    **{
        f"ring: {what}": (lambda n, data=data: named(data(n)), few, many)
        for what, data, few, many in (
            ("residues modulo a long number", lambda n: residues(number(n)), 9, LONG),
            ("residues modulo a large prime", lambda n: residues(PRIME), 1, 1),
            ("GF(p), p large", lambda n: finite(PRIME), 1, 1),
            ("GF(p), p long", lambda n: finite(number(n)), 9, 150),
            ("GF(2^64)", lambda n: GF_64, 1, 1),
            ("GF(193^64)", lambda n: GF_193, 1, 1),
            ("GF(p^6), p large", lambda n: GF_LONG, 1, 1),
            ("GF(2^n), no modulus", lambda n: finite(2, n), 13, 64),
            ("ℚ(√d), d large", lambda n: quadratic(10**9 - n), 63, 63),
            ("ℚ(√d), d long", lambda n: quadratic(number(n)), 20, LONG),
            ("ℚ(√m, …), all large", lambda n: multiquadratic(*range(10**9 - 5, 10**9)), 1, 1),
            ("a long modulus", long_modulus, 1, 65),
            ("long integers in a modulus", long_integers, 2, 450),
            ("powers in a modulus", equal_denominators, 40, 1_900),
            ("discs around close roots", moved_cyclotomic, 0, 15),
            ("ℚ(ⁿ√a), a long", lambda n: root_field(13 * number(n) + 2, 36), 3, LONG),
            (
                "ℚ(ⁿ√a), a long fraction",
                lambda n: root_field(fraction(13 * number(n) + 2, 13 * number(n, 1) + 1), 36),
                2,
                1_900,
            ),
            ("ℚ(ⁿ√a), no prime tells", lambda n: root_field(2, n), 8, 14),
            ("ℚ(ζₙ)", cyclotomic, 24, 150),
            ("ℚ(ζₙ), of too high a degree", cyclotomic, 360, 360),
            ("ℚ(cₙ)", lambda n: cyclotomic(n, True), 24, 330),
            ("GF(q)(t)", lambda n: functions(GF_193, "t" * n), 3, 100),
            ("functions on circles", lambda n: circles(n), 2, 4),
            ("many variables", lambda n: polynomials(ZZ, *MANY[:n]), 30, 64),
            ("long variables", lambda n: polynomials(QQ, *(v * 33 for v in MANY[:n])), 2, 64),
            ("ℚ_p", lambda n: completion(QQ, at_number(PRIME)), 1, 1),
            ("ℚ(√d) at p", lambda n: completion(quadratic(2), at_number(PRIME)), 1, 1),
            (
                "ℚ(√d) where p splits",
                lambda n: completion(quadratic(999_999_937), split(2, 1)),
                1,
                1,
            ),
            (
                "ℚ(ζ₄₁) at a large prime",
                lambda n: completion(
                    cyclotomic(41), ideal(PRIME_41[0], -PRIME_41[1], 1, *[0] * 38)
                ),
                1,
                1,
            ),
            ("ℚ[g]/(f) at 2", lambda n: completion(long_modulus(n), ideal(2)), 1, 65),
            (
                "ℚ[g]/(f) at a close real root",
                lambda n: completion(close_roots(n), real(1)),
                1,
                60,
            ),
            ("ℚ(cₙ) at a real root", lambda n: completion(cyclotomic(n, True), real(0)), 24, 330),
            (
                "GF(2)(t) at a prime",
                lambda n: completion(
                    functions(finite(2), "t"), prime_polynomial(finite(2), n)
                ),
                20,
                199,
            ),
            (
                "GF(2^64)(t) at a prime",
                lambda n: completion(functions(GF_64, "t"), prime_polynomial(GF_64, n)),
                2,
                90,
            ),
            (
                "GF(p^6)(t) at a prime",
                lambda n: completion(functions(GF_LONG, "t"), prime_polynomial(GF_LONG, n)),
                2,
                150,
            ),
            (
                "GF(p^6)(t) at infinity",
                lambda n: completion(functions(GF_LONG, "t"), INFINITY),
                1,
                1,
            ),
            ("completions of completions", nested, 3, 100),
            ("functions of functions", nested_functions, 3, 100),
        )
    },
    "rings: ℤ/n, n long": (
        partial(many_rings, lambda k: residues(number(280, k))), 2, 60,
    ),
    "rings: cyclotomic fields": (partial(many_rings, lambda k: cyclotomic(ORDERS[k])), 2, 60),
    "rings: ℚ(√d), d large": (
        partial(many_rings, lambda k: quadratic(PRIMES[k % 60])), 1, 60,
    ),
    "rings: one inside the other": (rings_in_rings, 2, 5),
    "rings: ℤ/n, not named": (
        partial(other_rings, lambda k: residues(PRIME - 168 * k)), 2, 19_000,
    ),
    "rings: ℚ(√d), not named": (
        partial(other_rings, lambda k: quadratic(PRIMES[k % 60])), 1, 19_000,
    ),
    "rings: number fields, not named": (
        partial(other_rings, lambda k: modulo_two(lambda m: (number(400, 40 * k + m), 0))), 2, 390,
    ),
    "rings: completions, not named": (
        partial(other_rings, lambda k: completion(QQ, at_number(PRIME))), 2, 19_000,
    ),
    "place of ℚ: a long number": (
        lambda n: at_place(QQ, at_number(2 * number(n) + 1), ratio(n), n // 33 + 1), 9, 990,
    ),
    "place of ℚ: powers": (
        lambda n: at_place(QQ, at_number(3), f"1/3**{n}", n // 350 + 1), 9, 9_900,
    ),
    "place of ℚ(√17): split, powers": (
        lambda n: at_place(quadratic(17), split(2, 1), f"sqrt(17)/2**{n}", n // 350 + 1), 9, 999,
    ),
    "place of ℚ(√d): split, a long number": (
        # √17 is a modulo a² − 17
        lambda n: at_place(quadratic(17), split(100**n - 17, 10**n), ratio(n), 9),
        9,
        490,
    ),
    "place of ℚ(√2): inert": (
        lambda n: at_place(quadratic(2), at_number(5), f"{ratio(n)}*sqrt(2)", n // 130 + 1),
        9,
        LONG,
    ),
    "place of ℚ(√2): a long number": (
        lambda n: at_place(quadratic(2), at_number(2 * number(n) + 1), f"{ratio(n)}*sqrt(2)", 30),
        9,
        990,
    ),
    "place of ℚ(√d): ramified": (
        lambda n: at_place(
            quadratic(999_999_937), at_number(999_999_937), f"sqrt(999999937)*{ratio(n)}", 30
        ),
        9,
        LONG,
    ),
    "place of ℚ(ζ₄₁): powers": (
        lambda n: at_place(
            cyclotomic(41), ideal(83, -30, 1, *[0] * 38), f"zeta41/83**{n}+1/83**{n}", n // 70 + 1
        ),
        2,
        2_000,
    ),
    "place of ℚ(ζ₄₁): a large prime": (
        lambda n: at_place(
            cyclotomic(41),
            ideal(PRIME_41[0], -PRIME_41[1], 1, *[0] * 38),
            f"zeta41*{ratio(n)}",
            n // 70 + 1,
        ),
        2,
        2_000,
    ),
    "place of ℚ(ζ₄₁): a long element": (long_element, 2, LONG // 2),
    "place of ℚ(ζ₄₁): another generator": (
        lambda n: at_place(cyclotomic(41), generator_modulo_83([number(n), 1, *[0] * 38]), "zeta41"),
        2,
        900,
    ),
    "place of ℚ(ζ₄₁): another generator, all long": (
        lambda n: at_place(
            cyclotomic(41), generator_modulo_83([number(n, k) for k in range(40)]), "zeta41"
        ),
        1,
        90,
    ),
    "place of ℚ[g]/(g³ − 2): powers": (
        lambda n: at_place(
            generated([-2, 0, 0, 1], "g"), ideal(2, 0, 1, 0), f"g/2**{n}+1/3", n // 350 + 1
        ),
        9,
        9_900,
    ),
    "place of ℚ[g]/(f): 2, inert": (
        lambda n: at_place(long_integers(n), ideal(2), f"g/2**{n}+1/3", n // 9 + 1), 2, 450,
    ),
    "place of ℚ[g]/(f): real, close together": (
        lambda n: ordered(close_roots(n), "g", n), 1, 60,
    ),
    "place of ℚ[g]/(f): real, long integers": (
        lambda n: ordered(long_integers(n), f"g-{ratio(n)}", 5), 2, 400,
    ),
    "place of GF(2)(t): of degree 199": (
        lambda n: at_place(
            functions(finite(2), "t"), prime_polynomial(finite(2), 199), f"(t+1)**{n}", 9
        ),
        3,
        900,
    ),
    "place of GF(2^64)(t): of high degree": (
        lambda n: at_place(
            functions(GF_64, "t"), prime_polynomial(GF_64, n), f"(t+x)**{n}", 3
        ),
        2,
        200,
    ),
    "place of GF(2^64)(t): powers": (
        lambda n: at_place(functions(GF_64, "t"), prime([0, 1, *[0] * 62], [1, *[0] * 63]), f"(t+x)**{n}", 3),
        2,
        900,
    ),
    "place of GF(p^6)(t): infinity": (
        lambda n: at_place(functions(GF_LONG, "t"), INFINITY, f"(t+x)**{n}", 3), 2, 900,
    ),
    "place of QQ(x): a specialisation": (specialised, 5, 90),
}  # fmt: skip
