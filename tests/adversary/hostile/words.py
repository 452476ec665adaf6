"""Dear statements in the vocabulary of the ledger, and about lattices."""

from functools import partial
from typing import Any

from hfield.checker.glossary import CIRCLE, INDUCTION, KULIKOV, REAL_ROOTS
from tests.adversary.hostile.rings import GF_64
from tests.adversary.hostile.writing import LENGTH, LONG, Hostile, number, proved, ratio, repeated
from tests.checker.cases import Field
from tests.checker.ring_data import QQ, Data, cyclotomic, finite, functions, ideal, quadratic
from tests.checker.ring_data import number as at_number

TRIANGULAR = ";".join(",".join("0" * m + "1" + "7" * (5 - m)) for m in range(6))


def every(part: str, evidence: Any, field: Field, method: str, n: int, **changes: Any) -> str:
    """The same, again and again."""
    parts = [{"verdict": "proved", "evidence": evidence}] * n
    inside = {"kind": "parts", "parts": parts}
    return proved(f"every{{{';'.join([part] * n)}}}", inside, field, method=method, **changes)


def every_refuted(part: str, evidence: Any, field: Field, method: str, n: int) -> str:
    """The same within what is said of the same: as "refutes" makes no list, one within the other."""
    for _ in range(min(n, 6)):
        part, evidence = f"every{{{part}}}", {"kind": "part", "part": 0, "evidence": evidence}
    return proved(part, evidence, field, verdict="refuted", method=method)


def logic(word: str, kind: str, verdict: str, left: str, right: str, method: str, n: int) -> str:
    """Two long statements over a finite field, all cases of which are tried."""
    goal = repeated("s**9", "+", n, LENGTH // 4)
    true, false = f"{goal} == {goal}", f"{goal} != {goal}"
    shown = {"kind": "exhaustion", "cases": 7}
    wrong = {"kind": "witness", "ring": finite(7), "values": {"s": ["1"]}}
    parts = {"proved": (true, shown), "refuted": (false, wrong)}
    sides = {
        side: {"verdict": v, "evidence": parts[v][1]}
        for side, v in (("left", left), ("right", right))
    }
    only = {"conclusion": parts[right][1], "hypothesis": parts[left][1]}
    evidence = {"kind": kind, **(sides if kind == "both" else {"evidence": only[kind]})}
    statement = f"{word}{{{parts[left][0]}; {parts[right][0]}}}"
    return proved(statement, evidence, finite(7), verdict=verdict, method=method)


def not_everywhere(n: int) -> str:
    goal = repeated("(p*q)[0]", "+", n)
    values = {q: [ratio(n, k) for k in range(4)] for q in "pq"}
    witness = {"kind": "witness", "ring": quadratic(999_999_937), "values": values}
    evidence = {"kind": "over", "ring": quadratic(999_999_937), "evidence": witness}
    return proved(f"not-everywhere{{{goal} == 0}}", evidence, None, method="witness")


def angles(n: int) -> str:
    goal = repeated("(s+t)**9", "+", n, LENGTH // 2)
    parts = [{"verdict": "proved", "evidence": {"kind": "identity"}}] * 2
    statement = f"angles{{{goal} == {goal}; s + sqrt(2) == sqrt(2) + s}}"
    return proved(
        statement, {"kind": "parts", "parts": parts}, "RR", method="identity", assumes=[CIRCLE]
    )


def citing(n: int) -> str:
    goal = repeated("(s+t)**9", "+", n, LENGTH // 2)
    return proved(
        f"citing{{induction; {goal} == {goal}}}", {"kind": "identity"}, assumes=[INDUCTION]
    )


def lemmas(n: int) -> str:
    """Proofs of lemmas, with long cofactors."""
    text = "*".join(["9"] * n)
    items = [{"characteristic": 0, "zero": ["2"], "relations": [], "member": "p[0]", "cofactors": [text],
              "denominator": 1}]  # fmt: skip
    proof = {"kind": "implication", "facts": [], "items": items}
    evidence = {"kind": "lemmas", "proofs": [proof, proof]}
    return proved("iff{p*q == q*p; 2 == 0}", evidence, method="implication")


def long_division_by(data: Data, place: Data, value: str, n: int) -> str:
    """Whether the norm form of H is 0 only at 0, at a place, for long elements."""
    own = {"u": [value] * 4, "j": [value, value, "0", "0"]}
    evidence = {"kind": "anisotropic", "by": "place", "place": place, **own}
    return proved("division", evidence, data, method="anisotropic norm")


def zero_norm(n: int) -> str:
    value = [ratio(n, k) for k in range(4)]
    evidence = {"kind": "zero norm", "value": value}
    return proved("division", evidence, "QQ", verdict="refuted", method="zero norm")


def norm_criterion(n: int) -> str:
    value = [f"{ratio(n, k)}*zeta41**{k + 9}" for k in range(4)]
    evidence = {"kind": "witness", "value": value, "norm": -number(n)}
    field = cyclotomic(41)
    return proved("norm-criterion{>}", evidence, field, verdict="refuted", method="witness")


def determined(n: int) -> str:
    words = [[a + b + c for a in "eijk" for b in "eijk" for c in "eijk"]]
    evidence = {"kind": "basis tuples", "tuples": words}
    return every("determined-by{all; 3}", evidence, None, "basis tuples", n)


def all_choices(n: int) -> str:
    elements = [[str(k), "0", "0", "0"] for k in range(n)]
    evidence = {"kind": "all choices", "elements": elements, "roots": list(map(str, range(n)))}
    return proved("modulus-law{*}", evidence, "QQ", verdict="refuted")


def level(n: int) -> str:
    evidence = {"kind": "squares", "values": [ratio(LONG)] * n}
    return proved("formally-real", evidence, "QQ", verdict="refuted")


# --- lattices -----------------------------------------------------------------------------------------

ONE = [[int(m == n) for n in range(4)] for m in range(4)]
LIPSCHITZ = "1,0,0,0|0,1,0,0|0,0,1,0|0,0,0,1"


def skewed(digits: int) -> list[list[int]]:
    """Return a basis of ℤ⁴ with long entries."""
    rows, n = [list(row) for row in ONE], number(max(1, digits // 3))
    for m in range(1, 4):
        rows[m] = [a + n * b for a, b in zip(rows[m], rows[m - 1], strict=True)]
    return rows


def rows_text(digits: int, seed: int = 0) -> str:
    return "|".join(",".join(ratio(digits, seed + 4 * m + n) for n in range(4)) for m in range(4))


def about(statement: str, evidence: Any, algebra: str = "(-1,-1|QQ)", **changes: Any) -> str:
    kind = statement.partition("{")[0]
    return proved(statement, {"kind": kind, **evidence}, "QQ", algebra=algebra, **changes)


def embedding(n: int) -> str:
    basis = {"den": 1, "rows": skewed(n)}
    statement = f"embedding{{{LIPSCHITZ}; -{4 * 997 + 3}}}"
    return about(statement, {"basis": basis}, verdict="refuted", method="enumeration")


def embedding_lines(n: int) -> str:
    """Long lines and short minors: every vector is found, and slowly."""
    rows = [ONE[0], *([number(n, m), *row[1:]] for m, row in enumerate(ONE[1:]))]
    statement = f"embedding{{{LIPSCHITZ}; -{4 * 1_000 * 64}}}"
    return about(
        statement, {"basis": {"den": 1, "rows": rows}}, verdict="refuted", method="enumeration"
    )


def embedding_far(n: int) -> str:
    """A discriminant so large that too many elements would be run through."""
    basis = {"den": 1, "rows": ONE}
    statement = f"embedding{{{LIPSCHITZ}; -{number(n) * 4 + 3}}}"
    return about(statement, {"basis": basis}, verdict="refuted", method="enumeration")


def embedded(n: int) -> str:
    """An element with long coordinates."""
    element = [ratio(n, k) for k in range(4)]
    return about(f"embedding{{{LIPSCHITZ}; -4}}", {"element": element}, method="element")


def conjugate(n: int) -> str:
    element = [ratio(n, k) for k in range(4)]
    statement = f"isomorphic-orders{{{LIPSCHITZ}; {LIPSCHITZ}}}"
    return about(statement, {"element": element}, method="element")


def between_equals(n: int) -> str:
    """All elements of a norm, by a long basis."""
    statement = f"equivalent{{left; {LIPSCHITZ}; {LIPSCHITZ}}}"
    evidence = {"between": {"den": 1, "rows": skewed(n)}}
    return about(statement, evidence, verdict="refuted", method="enumeration")


def long_order(n: int) -> str:
    return about(f"order{{{rows_text(n)}; 1}}", {})


def long_algebra(n: int) -> str:
    algebra = f"[-{ratio(n)},-{ratio(n, 1)},{ratio(n, 2)}|QQ)"
    return about(f"order{{{LIPSCHITZ}; 1}}", {}, algebra)


def long_ideal(n: int) -> str:
    return about(f"ideal{{{rows_text(n // 2)}; left; {rows_text(n // 2, 50)}; 1}}", {})


def equivalent_lattices(n: int) -> str:
    statement = f"equivalent{{left; {rows_text(n // 2)}; {rows_text(n // 2, 50)}}}"
    return about(statement, {"element": [ratio(LONG // 2, k) for k in range(4)]})


def unequal_lattices(n: int) -> str:
    statement = f"equivalent{{left; {rows_text(n // 2)}; {rows_text(n // 2, 50)}}}"
    return about(statement, {"between": {"den": 1, "rows": skewed(LONG)}}, verdict="refuted")


def many_orders(n: int) -> str:
    """The least vectors of every class, whose bases are long."""
    classes = [{"den": 1, "rows": skewed(3 * k + 3)} for k in range(n)]
    return about(f"class-set{{{LIPSCHITZ}; {n}}}", {"classes": classes})


def same_order(n: int) -> str:
    classes = [{"den": 1, "rows": ONE}] * n
    return about(f"class-set{{{LIPSCHITZ}; {n}}}", {"classes": classes})


def isomorphic(n: int) -> str:
    bases = [{"den": 1, "rows": skewed(n)}] * 2
    statement = f"isomorphic-orders{{{LIPSCHITZ}; {LIPSCHITZ}}}"
    evidence = {"trace": 0, "norm": 30, "bases": bases}
    return about(statement, evidence, verdict="refuted", method="enumeration")


def factoring(n: int) -> str:
    """A discriminant with two large primes."""
    rows = f"1,0,0,0|0,{n},0,0|0,0,{n},0|0,0,0,{n}"
    return about(f"order{{{rows}; {4 * n**3}; maximal}}", {})


FILES: dict[str, Hostile] = {
    "every: determinants": (
        partial(every, f"basis{{6;{TRIANGULAR}}}", {"kind": "determinant"}, None, "determinant"),
        1,
        64,
    ),
    "every: forms": (
        partial(every, "last-argument{4;1,2,3,4}", {"kind": "identity"}, None, "identity"),
        1,
        64,
    ),
    "every: linear maps": (
        partial(every, "curried-linear{1}", {"kind": "identity"}, None, "identity"),
        1,
        64,
    ),
    "every: minors": (
        partial(
            every,
            "centre{2}",
            {"kind": "minor", "rows": [2, 3, 7], "columns": [1, 2, 3]},
            None,
            "Smith form",
        ),
        1,
        64,
    ),
    "every: tuples": (determined, 1, 64),
    "every: a tuple left out": (
        partial(
            every_refuted,
            "determined-by{short; 3}",
            {"kind": "left out", "tuple": "kkk"},
            "QQ",
            "basis tuples",
        ),
        1,
        6,
    ),
    "every: orderings": (
        partial(every, "norm-criterion{>}", {"kind": "ordering"}, cyclotomic(79, True), "ordering"),
        1,
        64,
    ),
    "every: levels": (
        partial(every, "level-above{3}", {"kind": "level"}, cyclotomic(31), "level"),
        1,
        64,
    ),
    "every: roots of norms": (
        partial(
            every, "modulus-exists", {"kind": "closed"}, "RR", "closed field", assumes=[REAL_ROOTS]
        ),
        1,
        64,
    ),
    "every: norms that are squares": (
        partial(every, "modulus-exists", {"kind": "identity"}, GF_64, "identity"),
        1,
        64,
    ),
    "every: roots in characteristic 2": (
        partial(
            every, "modulus-law{*}", {"kind": "unique roots"}, functions(GF_64, "t"), "unique roots"
        ),
        1,
        64,
    ),
    "every: positive roots": (
        partial(every, "modulus-law{*}", {"kind": "ordering"}, cyclotomic(79, True), "ordering"),
        1,
        64,
    ),
    "every: a pure subgroup": (
        partial(
            every,
            "modulus-law{*}",
            {"kind": "pure subgroup"},
            cyclotomic(79, True),
            "choice of roots",
            assumes=[KULIKOV],
        ),
        1,
        64,
    ),
    "every: roots in GF(p)": (
        partial(every, "modulus-law{*}", {"kind": "square roots"}, finite(251), "exhaustion"),
        1,
        64,
    ),
    **{
        f"{word}: {kind}, {verdict} by {method}": (
            partial(logic, word, kind, verdict, left, right, method),
            2,
            900,
        )
        for word, kind, verdict, left, right, method in (
            ("implies", "conclusion", "proved", "refuted", "proved", "exhaustion"),
            ("implies", "hypothesis", "vacuous", "refuted", "refuted", "witness"),
            ("implies", "both", "refuted", "proved", "refuted", "witness"),
            ("iff", "both", "proved", "proved", "proved", "exhaustion"),
            ("iff", "both", "proved", "refuted", "refuted", "witness"),
            ("iff", "both", "refuted", "proved", "refuted", "exhaustion; witness"),
        )
    },
    "iff: lemmas": (lemmas, 20, LONG),
    "not-everywhere: long values": (not_everywhere, 3, LONG // 2),
    "angles: long": (angles, 2, 900),
    "citing: long": (citing, 2, 900),
    "division: at a number": (lambda n: long_division_by(QQ, at_number(2), ratio(n), n), 3, LONG),
    "division: at a prime ideal": (
        lambda n: long_division_by(
            cyclotomic(41), ideal(83, -30, 1, *[0] * 38), f"{ratio(n)}*zeta41**40", n
        ),
        3,
        LONG,
    ),
    "division: an element": (zero_norm, 3, LONG),
    "norm-criterion: an element": (norm_criterion, 3, LONG),
    "modulus-law: all choices": (all_choices, 3, 8),
    "formally-real: long squares": (level, 3, 900),
    "embedding: a long basis": (embedding, 30, LONG),
    "embedding: long lines": (embedding_lines, 30, LONG),
    "embedding: a large discriminant": (embedding_far, 3, 60),
    "embedding: a long element": (embedded, 3, LONG),
    "isomorphic-orders: a long element": (conjugate, 3, LONG),
    "equivalent, refuted: a long basis": (between_equals, 3, LONG),
    "order: long rows": (long_order, 5, 550),
    "order: a long algebra": (long_algebra, 5, 1_900),
    "ideal: long rows": (long_ideal, 6, 560),
    "equivalent: long rows": (equivalent_lattices, 6, 560),
    "equivalent, refuted: long rows": (unequal_lattices, 6, 560),
    "class-set: long bases": (many_orders, 5, 200),
    "class-set: many classes": (same_order, 5, 19_000),
    "isomorphic-orders: long bases": (isomorphic, 30, LONG),
    "order: two large primes": (factoring, 1_009, 1_000_003 * 1_000_033),
}
