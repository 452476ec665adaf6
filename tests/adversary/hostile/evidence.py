"""Dear evidence of the other kinds."""

from typing import Any

from hfield.checker.glossary import COMPLEX_ROOT, ODD_DEGREE, REAL_ROOTS
from tests.adversary.hostile.rings import GF_64, close_roots
from tests.adversary.hostile.writing import (
    IDENTITY,
    LENGTH,
    LONG,
    Hostile,
    joined,
    number,
    proved,
    ratio,
    repeated,
)
from tests.checker.cases import Field
from tests.checker.ring_data import QQ, ZZ, Data, completion, functions, polynomials, quadratic
from tests.checker.ring_data import number as at_number


def tried(field: Field, statement: str, count: int) -> str:
    return proved(statement, {"kind": "exhaustion", "cases": count}, field)


def with_terms(n: int) -> str:
    """A long term for each of many places."""
    names = "ztyx"
    evidence = {"kind": "terms", "terms": {v: repeated("s", "+", n) for v in names}}
    goal = repeated("z+t+y+x", "+", n, 15_000)
    whole = {**evidence, "proof": IDENTITY}
    return proved(f"exists {', '.join(names)}: {goal} == s", whole, method="witness")


def with_calls(n: int) -> str:
    """A long term inside of calls."""
    evidence = {"kind": "terms", "terms": {"q": repeated("p", "+", n)}, "proof": IDENTITY}
    goal = repeated("q", "+", n, 15_000)
    return proved(f"exists q: {'conj(' * 90}{goal}{')' * 90} == p", evidence, method="witness")


def with_cases(n: int) -> str:
    own = {"when": "s == 0", "terms": {"t": repeated("s", "+", n)}, "proof": IDENTITY}
    evidence = {"kind": "cases", "cases": [own] * 60, "cover": IDENTITY}
    goal = repeated("t", "+", n, 15_000)
    return proved(f"exists t: {goal} == s", evidence, method="witness")


def real_root(n: int) -> str:
    evidence = {"kind": "real root", "by": "sign change", "between": [ratio(n), ratio(n, 1)]}
    text = joined(f"{k}*s**{k}" for k in range(1, 900))
    return proved(f"exists s: {text} == 1", evidence, "RR", method="witness")


def quaternion_root(n: int) -> str:
    text = f"{'(' * 90}q{'+p)' * 90}"
    goal = repeated(text, "+", n)
    return proved(f"exists q: {goal} == 1", {"kind": "quaternion root"}, "RR", method="witness")


def reduction(n: int) -> str:
    proof: Any = IDENTITY
    for k in range(50):
        proof = {"kind": "reduction", "modulus": 2 ** (9_000 - 50 + k), "proof": proof}
    goal = repeated("(s+t+y)**9", "+", n)
    return proved(f"{goal} != 1", proof, "ZZ")


def complex_root(n: int) -> str:
    text = joined(f"({number(9, k)}+t)*s**{k}" for k in range(1, 800))
    goal = repeated("t*s", "+", n, 900)
    return proved(
        f"exists s: s**950+{text} == {goal}",
        {"kind": "complex root"},
        "CC",
        method="witness",
        assumes=[COMPLEX_ROOT],
    )


def odd_degree(n: int) -> str:
    text = repeated("(s+t)**99", "+", n)
    evidence = {"kind": "real root", "by": "odd degree"}
    statement = f"exists s: {text} == 1"
    return proved(statement, evidence, "RR", method="witness", assumes=[ODD_DEGREE])


def real_square(n: int) -> str:
    text = f"({'+'.join(f'{v}**2' for v in 'tyxz')})**{n}"
    evidence = {"kind": "real root", "by": "square"}
    return proved(
        f"exists s: s**2 == {text}", evidence, "RR", method="witness", assumes=[REAL_ROOTS]
    )


def from_fractions(n: int) -> str:
    goal = repeated("(s+t+y)**9", "+", n, LENGTH // 2)
    evidence = {"kind": "fractions", "ring": functions(QQ, "x"), "proof": IDENTITY}
    return proved(f"{goal} == {goal}", evidence, polynomials(ZZ, "x"), method="identity")


def subfield(data: Data, root: str, statement: str, verdict: str, n: int) -> str:
    """Values in a number field that lies in ℚ₃."""
    values = {"s": [repeated("sqrt(-41)" if data == quadratic(-41) else "g", "+", n)]}
    witness = {"kind": "witness", "ring": data, "values": values}
    evidence = {"kind": "subfield", "ring": data, "root": root, "witness": witness}
    ring = completion(QQ, at_number(3))
    method = "witness" if verdict == "proved" else "identity"
    return proved(statement, evidence, ring, verdict=verdict, method=method)


def long_root(n: int) -> str:
    return subfield(quadratic(-41), str(3 * number(n) + 1), "s == 0", "refuted", 1)


def root_of_high_degree(n: int) -> str:
    """Of X⁴⁰ − 7·(aX − 1)², at what is nearly 1/a."""
    root = ratio(n)
    return subfield(close_roots(10), root, "exists s: s == s", "proved", n)


def none_exists(n: int) -> str:
    goal = repeated("(s+t+y)**9", "+", n, LENGTH // 2)
    evidence = {"kind": "none exists", "ring": functions(GF_64, "u"), "proof": IDENTITY}
    statement = f"exists s, t, y: {goal} != {goal}"
    return proved(statement, evidence, verdict="refuted", method="identity")


def place(n: int) -> str:
    """Nothing exists for long values."""
    values = {"t": [ratio(n)], "p": [ratio(n, k) for k in range(4)]}
    inner = {"kind": "none exists", "proof": IDENTITY}
    goal = repeated("(p*t*s)[0]", "+", n, LENGTH // 2)
    evidence = {"kind": "place", "values": values, "proof": inner}
    statement = f"exists s: {goal} != {goal}"
    return proved(statement, evidence, "QQ", verdict="refuted", method="identity")


def never(n: int) -> str:
    """Hypotheses that are never true, and something to exist."""
    goal = repeated("(s+t+y)**9", "+", n, LENGTH // 2)
    evidence = {"kind": "unsatisfiable", "proof": IDENTITY}
    statement = f"{goal} != {goal} => (exists x: x == 1)"
    return proved(statement, evidence, verdict="vacuous", method="identity")


def multilinear(n: int) -> str:
    words = [f"{a}{b}{c}" for a in "eijk" for b in "eijk" for c in "eijk"]
    evidence = {"kind": "multilinear", "unknowns": ["p", "q", "r"]}
    text = repeated("p*(q*r)", "+", n, LENGTH // 2)
    listed = [[w, [0, 0, 0, 0]] for w in words]
    return proved(f"{text} == {text}", {**evidence, "tuples": listed})


def degrees(n: int) -> str:
    total = "(p+q+r+u+v+w)"
    text = repeated(f"{total}*{total}*{total}*({total}*{total}*{total})", "+", n)
    evidence = {"kind": "multilinear", "unknowns": list("pqruvw"), "tuples": [["", [0] * 4]]}
    return proved(f"{text} == p", evidence)


def unsatisfiable(n: int) -> str:
    goal = repeated("(s+t+y)**9", "+", n)
    evidence = {"kind": "unsatisfiable", "proof": IDENTITY}
    return proved(f"{goal} == 1 => s == 1", evidence, verdict="vacuous")


# --- words --------------------------------------------------------------------------------------------


def presented(statement: str, proofs: Any, relations: Any, goals: Any) -> str:
    evidence = {
        "kind": "presentation", "characteristic": 0, "identity": True, "relations": relations,
        "goals": goals, "proofs": proofs,
    }  # fmt: skip
    return proved(f"associative(i, j, k): {statement}", evidence)


def read_words(n: int) -> str:
    unit = [[1, "i"]]
    proofs = [{"cofactors": [], "denominator": 1}]
    return presented(f"{repeated('(i+j)**12', '+', n)} == 0 => i == 0", proofs, [unit], [unit])


def long_words(n: int) -> str:
    """Each multiple of a relation has words of its own, and long coefficients."""
    text = joined(f"{'*'.join('ij'[int(b)] for b in f'{k:08b}')}" for k in range(200))
    relation = [[1, "".join("ij"[int(b)] for b in f"{k:08b}")] for k in range(200)]
    multiples = [
        [number(LONG, 1), "".join("ij"[int(b)] for b in f"{k:015b}"), 0, ""] for k in range(n)
    ]
    proofs = [{"cofactors": multiples, "denominator": 1}]
    return presented(f"{text} == 0 => i == 0", proofs, [relation], [[[1, "i"]]])


def table(n: int) -> str:
    evidence = {
        "kind": "algebra", "characteristic": 0, "identity": True,
        "relations": [[[1, "i" * 200]]] , "goals": [[[1, "i"]]], "goal": 0, "value": [0, 1, 0, 0],
        "table": {x + y: [10**9] * 4 for x in "eijk" for y in "eijk"},
    }  # fmt: skip
    text = f"associative(i, j, k): {repeated('i**200 == 0', ' and ', n)} => i == 0"
    return proved(text, evidence, verdict="refuted")


FILES: dict[str, Hostile] = {
    "exhaustion: powers": (
        lambda n: tried(
            "GF(4999)", f"{joined(f's**{k}' for k in range(n, 1, -1))} == s or s != 1", 4999
        ),
        40,
        2_000,
    ),
    "exhaustion: clauses": (
        lambda n: tried(
            "GF(4999)", f"{joined(f's**{k}*t' for k in range(n, 1, -1))} == s or s != t", 4999**2
        ),
        40,
        2_000,
    ),
    "exhaustion: GF(4096)": (
        lambda n: tried(
            "GF(4096)",
            f"{joined(f'x**{k}*s**{k}*t' for k in range(n, 1, -1))} == s or s != t",
            4096**2,
        ),
        20,
        900,
    ),
    "exhaustion: quaternions": (lambda n: tried("GF(7)", f"(p*q)**{n} == (q*p)**{n}", 7**8), 2, 12),
    "exhaustion: evaluated": (
        lambda n: tried("ZZ/4", f"{repeated('s**9999', '+', n)} == 1/s", 4),
        5,
        2_000,
    ),
    "exhaustion: high powers of quaternions": (
        lambda n: tried("ZZ/8", f"{repeated('q**9999', '+', n)} == 1/q[0]", 8**4),
        3,
        2_000,
    ),
    "exhaustion: exists": (
        lambda n: tried("ZZ/6", f"exists s: {repeated('q**9', '+', n)} == s*i + i", 6**4),
        5,
        2_000,
    ),
    "terms: long terms": (with_terms, 30, 9_000),
    "terms: in calls": (with_calls, 30, 9_000),
    "cases: long terms": (with_cases, 30, 9_000),
    "real root: a change of sign": (real_root, 2, LONG),
    "quaternion root: high": (quaternion_root, 2, 400),
    "reduction: again and again": (reduction, 2, 1_900),
    "complex root: many terms": (complex_root, 3, 1_000),
    "real root: of odd degree": (odd_degree, 2, 1_900),
    "real root: a square": (real_square, 2, 90),
    "fractions: long": (from_fractions, 2, 1_800),
    "subfield: a long root": (long_root, 30, LONG),
    "subfield: of high degree": (root_of_high_degree, 3, LONG),
    "none exists: long": (none_exists, 2, 900),
    "place: long values": (place, 2, LONG // 2),
    "unsatisfiable: existence": (never, 2, 900),
    "multilinear: long sides": (multilinear, 4, 2_000),
    "multilinear: many degrees": (degrees, 1, 200),
    "unsatisfiable: long": (unsatisfiable, 2, 1_800),
    "presentation: words of a statement": (read_words, 1, 1_900),
    "presentation: long coefficients": (long_words, 5, 1_900),
    "algebra: long words": (table, 2, 1_500),
}
