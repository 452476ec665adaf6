"""Dear statements in the vocabulary of the ledger, and about lattices."""

from typing import Any

from tests.adversary.hostile.writing import LONG, Hostile, number, proved, ratio


def every(part: str, evidence: Any, field: str | None, n: int) -> str:
    parts = [{"verdict": "proved", "evidence": evidence}] * n
    return proved(f"every{{{';'.join([part] * n)}}}", {"kind": "parts", "parts": parts}, field)


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
        lambda n: every(
            f"basis{{6;{';'.join(','.join(['7'] * 6) for _ in range(6))}}}",
            {"kind": "determinant"},
            None,
            n,
        ),
        1,
        64,
    ),
    "every: forms": (
        lambda n: every("last-argument{4;1,2,3,4}", {"kind": "identity"}, None, n),
        1,
        64,
    ),
    "modulus-law: all choices": (all_choices, 3, 8),
    "modulus-law: all pairs of roots": (
        lambda n: proved("modulus-law{*}", {"kind": "square roots"}, f"GF({n})"),
        7,
        251,
    ),
    "formally-real: long squares": (level, 3, 900),
    "embedding: a long basis": (embedding, 30, LONG),
    "embedding: long lines": (embedding_lines, 30, LONG),
    "embedding: a large discriminant": (embedding_far, 3, 60),
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
