"""Section 1.4.3: quaternions as 2 × 2 matrices over C.

The complex numbers of the thesis are the elements ``a + b·i`` of H(F): they commute with each
other, and ``conj`` is their conjugation. So every entry below is a term of the language, and the
claims have their algebraic core F(i) = F·e + F·i over every commutative ring.
"""

from hfield.ledger.document import Propositions
from hfield.ledger.propositions import Statement

Matrix = tuple[tuple[str, str], tuple[str, str]]

E: Matrix = (("e", "0*e"), ("0*e", "e"))
I: Matrix = (("i", "0*e"), ("0*e", "-i"))  # noqa: E741  the names of the thesis
J: Matrix = (("0*e", "e"), ("-e", "0*e"))
K: Matrix = (("0*e", "i"), ("i", "0*e"))
PRODUCTS = {
    "EE": ("", E), "EI": ("", I), "EJ": ("", J), "EK": ("", K),
    "IE": ("", I), "II": ("-", E), "IJ": ("", K), "IK": ("-", J),
    "JE": ("", J), "JI": ("-", K), "JJ": ("-", E), "JK": ("", I),
    "KE": ("", K), "KI": ("", J), "KJ": ("-", I), "KK": ("-", E),
}  # fmt: skip


def form(z: str, w: str) -> Matrix:
    """Return the matrix ``[[z, w], [−w̄, z̄]]`` of V."""
    return ((z, w), (f"-conj({w})", f"conj({z})"))


def matrix(q: str) -> Matrix:
    """Return the matrix of the quaternion ``q``: z = a + bi, w = c + di."""
    return form(f"(({q})[0] + ({q})[1]*i)", f"(({q})[2] + ({q})[3]*i)")


def times(m: Matrix, n: Matrix) -> Matrix:
    """Return the matrix product as text."""
    (a, b), (c, d) = m
    (s, t), (u, v) = n
    return (
        (f"({a})*({s}) + ({b})*({u})", f"({a})*({t}) + ({b})*({v})"),
        (f"({c})*({s}) + ({d})*({u})", f"({c})*({t}) + ({d})*({v})"),
    )


def combination(terms: list[tuple[str, Matrix]]) -> Matrix:
    """Return the linear combination with the scalar coefficients given, as text."""

    def entry(r: int, c: int) -> str:
        return " + ".join(f"{s}*({m[r][c]})" for s, m in terms)

    return ((entry(0, 0), entry(0, 1)), (entry(1, 0), entry(1, 1)))


def equal(m: Matrix, n: Matrix) -> str:
    """Return the equality of two matrices, entry by entry."""
    return " and ".join(f"{m[r][c]} == {n[r][c]}" for r in (0, 1) for c in (0, 1))


def table(sign_of_ji: str) -> str:
    """Return Table 1.1 for the four matrices."""
    letters = {"E": E, "I": I, "J": J, "K": K}
    parts = []
    for pair, (sign, result) in PRODUCTS.items():
        s = sign_of_ji if pair == "JI" else sign
        product = times(letters[pair[0]], letters[pair[1]])
        parts.append(equal(product, combination([(f"{s}1", result)])))
    return " and ".join(parts)


COMPUTED = {
    "C1.4.3-c": Propositions(as_printed=Statement(table("-")), spoilt=Statement(table(""))),
}
