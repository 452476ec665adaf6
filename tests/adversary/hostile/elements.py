"""Dear elements of every kind of ring: in witnesses, in sums of squares, their signs, their roots."""

from collections.abc import Callable
from functools import partial

from tests.adversary.hostile.rings import GF_64, GF_LONG, MANY, PRIME, long_modulus
from tests.adversary.hostile.writing import (
    LONG,
    Hostile,
    fact_about_norms,
    joined,
    name_of,
    number,
    proved,
    ratio,
    repeated,
)
from tests.checker.ring_data import (
    CC,
    CDF,
    QQ,
    RDF,
    RR,
    ZZ,
    Data,
    completion,
    cyclotomic,
    finite,
    functions,
    multiquadratic,
    polynomials,
    prime,
    quadratic,
    real,
    residues,
    root_field,
    split,
)
from tests.checker.ring_data import number as at_number

ROOTS = (2, 3, 5, 7, 11)
C_79 = cyclotomic(79, True)


def in_powers(name: str, high: int, long: int, n: int) -> str:
    """Return an element: a sum of powers with long coefficients."""
    return joined(f"({ratio(max(1, long * n // 100), k)})*{name}**{k}" for k in range(high))


RINGS: dict[str, tuple[Data, Callable[[int], str]]] = {
    "QQ": (QQ, lambda n: ratio(LONG * n // 100)),
    "ZZ": (ZZ, lambda n: str(number(LONG * n // 100))),
    "ZZ/n": (residues(number(LONG)), lambda n: str(number(LONG * n // 100))),
    "GF(p)": (finite(PRIME), lambda n: str(number(20))),
    "GF(p^6)": (
        GF_LONG,
        lambda n: joined(f"{number(20, k)}*x**{k}" for k in range(1 + n * 5 // 100)),
    ),
    "GF(2^64)": (GF_64, lambda n: joined(f"x**{k}" for k in range(1 + n * 63 // 100))),
    "RR": (RR, lambda n: "+".join(f"({ratio(n)})*sqrt({d})" for d in (2, 3, 5, 6, 7, 10, 11, 13))),
    "RR, many primes": (RR, lambda n: joined((f"sqrt({d})" for d in SQUAREFREE[: 10 * n]), "*")),
    "CC": (CC, lambda n: "+".join(f"({ratio(9 * n)})*sqrt(-{d})" for d in (2, 3, 5, 6, 7, 10))),
    "QQ(I)": (quadratic(-1), lambda n: f"{ratio(LONG * n // 100)}+{ratio(39 * n)}*I"),
    "QQ(√2)": (quadratic(2), lambda n: f"{ratio(39 * n)}+{ratio(39 * n)}*sqrt(2)"),
    "QQ(√2, …)": (
        multiquadratic(*ROOTS),
        lambda n: "*".join(f"(1+{ratio(2 * n)}*sqrt({d}))" for d in ROOTS),
    ),
    "QQ(ζ₄₁)": (cyclotomic(41), partial(in_powers, "zeta41", 40, 200)),
    "QQ(c₇₉)": (C_79, partial(in_powers, "c79", 39, 200)),
    "QQ(root(2,25))": (root_field(2, 25), partial(in_powers, "root(2,25)", 25, 200)),
    "QQ[g]/(f), long": (long_modulus(60), partial(in_powers, "g", 40, 200)),
    "QQ(x)": (
        functions(QQ, "x"),
        lambda n: f"({in_powers('x', n, 20, n)})/({in_powers('x', n, 30, n)})",
    ),
    "QQ(√2)(x)": (
        functions(quadratic(2), "x"),
        lambda n: f"(sqrt(2)+{in_powers('x', n, 20, n)})/({in_powers('x', n, 30, n)})",
    ),
    "QQ(x,g)": (
        {"kind": "rational functions", "base": QQ, "variables": ["x", "g"]},
        lambda n: f"(x**{n}+g**{n}+1)/(x*g**{n}+{n})",
    ),
    "QQ[x]/(x⁶⁰+1/3)": (
        {
            "kind": "quotient ring",
            "base": QQ,
            "modulus": ["1/3", *["0"] * 59, "1"],
            "variable": "x",
        },
        lambda n: f"1/({in_powers('x', 60, 200, n)})",
    ),
    "QQ[x]": (polynomials(QQ, "x"), lambda n: in_powers("x", 2 * n, 20, n)),
    "ZZ[a,…]": (polynomials(ZZ, *MANY), lambda n: joined(MANY[: 1 + 63 * n // 100])),
    "ZZ[a,b]": (polynomials(ZZ, "a", "b"), lambda n: f"(a+b+1)**{n // 2}"),
    "GF(5)(t)": (functions(finite(5), "t"), lambda n: f"(t**{4 * n}+t+1)/(t**{3 * n}+t**{n}+2)"),
    "GF(2^64)(t)": (functions(GF_64, "t"), lambda n: f"(x*t**{n}+x**63)/(t**{n}+x**7*t+x)"),
    "GF(9)((t))": (
        completion(functions(finite(3, 2, [2, 2, 1]), "t"), prime([0, 0], [1, 0])),
        lambda n: f"(x*t**{n}+x)/(t**{n}+2*t+x)",
    ),
    "Qp(5)": (completion(QQ, at_number(5)), lambda n: ratio(39 * n)),
    "QQ(√17)_(2, √17-1)": (
        completion(quadratic(17), split(2, 1)),
        lambda n: f"{ratio(39 * n)}+{ratio(39 * n)}*sqrt(17)",
    ),
    "QQ(c₇₉)_inf0": (completion(C_79, real(0)), partial(in_powers, "c79", 39, 200)),
    "RDF": (RDF, lambda n: str(2**52)),
    "CDF": (CDF, lambda n: str(2**52)),
}
CONSTANTS = {  # what has to occur in a statement so that facts may speak of it
    "RR": "+".join(f"sqrt({d})" for d in (2, 3, 5, 6, 7, 10, 11, 13)), "QQ(√2)": "sqrt(2)",
    "QQ(√2, …)": "+".join(f"sqrt({d})" for d in ROOTS), "QQ(x)": "x", "QQ(c₇₉)": "c79",
    "QQ(c₇₉)_inf0": "c79",
}  # fmt: skip
SHORT = {  # elements that structure constants may be
    ring: partial(in_powers, "c79", 9, 900) for ring in ("QQ(c₇₉)", "QQ(c₇₉)_inf0")
} | {"QQ(x)": lambda n: in_powers("x", 9, 400, n)}
SQUAREFREE = [
    str(n) for n in range(2, 4_000) if all(n % (d * d) for d in range(2, 64))
]  # fmt: skip
TERMS: dict[str, Callable[[int], str]] = {
    "sums that cancel": lambda n: repeated("s-s+y-y", "+", 20 * n),
    "products": lambda n: repeated("s*y-y*s", "+", 20 * n),
    "quotients": lambda n: repeated("s/y-1/s", "+", 20 * n),
    "quaternions": lambda n: repeated("p*q-q*p", "+", 20 * n),
    "powers": lambda n: repeated("s**999*y**999", "+", 20 * n),
    "high powers": lambda n: repeated("(p+s)**9999-q**9999", "+", 20 * n),
    "equalities": lambda n: repeated("s == y", " or ", 20 * n) + " or z",
}


def evaluated(ring: str, term: str, n: int) -> str:
    """A witness with values that are long, for a statement that computes with them."""
    data, value = RINGS[ring]
    statement, x = f"{TERMS[term](n)} == z", value(n)
    here = {"s": [x], "y": [x], "z": ["0"]}
    here |= {q: [x, "1", "0", x] for q in "pq"}
    found = {v: here[v] for v in here if v in statement}
    evidence = {"kind": "witness", "ring": data, "values": found}
    return proved(statement, evidence, data, verdict="refuted", method="identity")


def value_of(data: Data, text: str) -> str:
    """A witness that is a long text."""
    evidence = {"kind": "witness", "ring": data, "values": {"s": [text]}}
    return proved("s == 0", evidence, data, verdict="refuted", method="identity")


def values(data: Data, unit: str, sign: str, n: int) -> str:
    """Many long texts of elements, of which −1 should be the sum of the squares."""
    text = repeated(unit, sign, n)
    evidence = {"kind": "squares", "values": [text] * min(400, max(1, n // len(text)))}
    return proved("formally-real", evidence, data, verdict="refuted", method="sum of squares")


def signed(ring: str, n: int) -> str:
    """A sign, which needs precision: that of a difference that is nearly 0."""
    data, value = RINGS[ring]
    x = SHORT[ring](n) if ring in SHORT else value(n)
    algebra = f"(({x})**2-({x})*({x}+1),-1|{name_of(data)})"
    reasons = [{"by": "ordering", "algebra": algebra}]
    return fact_about_norms(reasons, data, CONSTANTS.get(ring, "0"))


def near_zero(n: int) -> str:
    """√2 and its best fractions: the sign of the difference takes as many digits as they have."""
    u, v = 1, 1
    while len(str(v)) < n:
        u, v = u + 2 * v, u + v
    reasons = [
        {"by": "ordering", "algebra": f"({u}/{v}-sqrt(2),{m}*({u}-{v}*sqrt(2))|RR)"}
        for m in range(1, 20)
    ]
    return fact_about_norms(reasons, RR, "sqrt(2)")


def many_roots_near_zero(n: int) -> str:
    roots = (2, 3, 5, 7, 11, 13, 17, 19)
    text = "-".join(f"{number(n, d)}*sqrt({d})" for d in roots)
    reasons = [{"by": "ordering", "algebra": f"({text},-1|RR)"}]
    return fact_about_norms(reasons, RR, "+".join(f"sqrt({d})" for d in roots))


def squareness(ring: str, n: int) -> str:
    """Whether a norm is a square."""
    data, value = RINGS[ring]
    x = value(n)
    evidence = {"kind": "no root", "value": [x, x, "1", "0"]}
    return proved("modulus-exists", evidence, data, verdict="refuted", method="witness")


FILES: dict[str, Hostile] = {
    **{
        f"witness over {ring}: {term}": (partial(evaluated, ring, term), 1, 100)
        for ring in RINGS
        for term in TERMS
    },
    "witness: a long term": (lambda n: value_of(QQ, repeated("1", "+", n)), 200, 9_000),
    "words: long terms": (partial(values, QQ, "1", "+"), 500, 7_000_000),
    "words: signs": (partial(values, QQ, "- 1", "+"), 500, 7_000_000),
    "words: parentheses": (partial(values, QQ, "((((1))))", "+"), 500, 7_000_000),
    "words: powers": (partial(values, QQ, "3**999", "+"), 500, 7_000_000),
    "words: powers in GF(5)": (partial(values, finite(5), "2**9999", "+"), 500, 7_000_000),
    "words: names of many": (
        partial(values, completion(C_79, real(0)), "c79", "+"),
        500,
        7_000_000,
    ),
    "words: names": (partial(values, quadratic(-1), "I", "+"), 500, 7_000_000),
    "words: decimals": (partial(values, QQ, "1e9", "+"), 500, 7_000_000),
    **{
        f"ordering of {ring}": (partial(signed, ring), 1, 4)
        for ring in ("QQ", "RR", "QQ(√2)", "QQ(√2, …)", "QQ(c₇₉)", "QQ(x)", "QQ(c₇₉)_inf0")
    },
    "ordering of RR: nearly 0": (near_zero, 20, 500),
    "ordering of RR: many roots": (many_roots_near_zero, 20, 1_900),
    **{
        f"squares of {ring}": (partial(squareness, ring), 2, 40)
        for ring in RINGS
        if ring
        not in ("ZZ", "ZZ/n", "QQ[x]", "QQ[x]/(x⁶⁰+1/3)", "ZZ[a,…]", "ZZ[a,b]", "RDF", "CDF")
    },
}
