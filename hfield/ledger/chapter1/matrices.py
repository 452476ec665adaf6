"""Section 1.4.3: quaternions as 2 × 2 matrices over C.

The complex numbers of the thesis are the elements ``a + b·i`` of H(F): they commute with each
other, and ``conj`` is their conjugation. So every entry below is a term of the language, and the
claims have their algebraic core F(i) = F·e + F·i over every commutative ring.
"""

from hfield.ledger.claim import Claim
from hfield.ledger.propositions import Every, Statement

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
PRINTED: Matrix = (("(q[0] + q[1]*i)", "(q[2] + q[3]*i)"), ("(q[2] - q[3]*i)", "(q[0] - q[1]*i)"))
CONJUGATE: Matrix = (
    ("(q[0] - q[1]*i)", "(-q[2] - q[3]*i)"),
    ("(q[2] - q[3]*i)", "(q[0] + q[1]*i)"),
)


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


def adjoint(m: Matrix) -> Matrix:
    """Return the Hermitian adjoint: transposed and conjugated."""
    (a, b), (c, d) = m
    return ((f"conj({a})", f"conj({c})"), (f"conj({b})", f"conj({d})"))


def det(m: Matrix) -> str:
    """Return the determinant as text."""
    (a, b), (c, d) = m
    return f"({a})*({d}) - ({b})*({c})"


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


Q = matrix("q")
SUM = [("q[0]", E), ("q[1]", I), ("q[2]", J), ("q[3]", K)]
SIMILAR = equal(combination([("s", matrix("p")), ("y", Q)]), matrix("s*p + y*q"))
FREE = equal(matrix("p"), Q) + " => p == q"
INVERSE = form("conj(q[0] + q[1]*i)/norm(q)", "-(q[2] + q[3]*i)/norm(q)")

CLAIMS = (
    Claim(
        "C1.4.3-a",
        "matrix-subspace",
        "claim",
        "V={[[z,w],[−w̄,z̄]]} is a linear subspace of M2(C)",
        "podprzestrzenią liniową M2(C)",
        Statement(SIMILAR),
        spoilt=Statement(SIMILAR.replace("s*(", "(s*i)*(").replace("s*p", "(s*i)*p")),
        note="Read over F = R, as everything here; over C it is none, for i·V is not in V.",
    ),
    Claim(
        "C1.4.3-b",
        "matrix-basis",
        "claim",
        "The four matrices listed form a basis of V",
        "e,i,j,k matrices",
        Every((Statement(equal(combination(SUM), Q)), Statement(FREE))),
        spoilt=Statement(equal(combination([*SUM[:3], ("q[3]", J)]), Q)),
    ),
    Claim(
        "C1.4.3-c",
        "matrix-table",
        "claim",
        "The four matrices satisfy Table 1.1",
        "spełnia warunki z tabeli 1.1",
        Statement(table("-")),
        spoilt=Statement(table("")),
    ),
    Claim(
        "C1.4.3-d",
        "matrix-form",
        "formula",
        "The summed matrix form",
        "q=[[a+ib, c+id],[c−id, a−ib]]",
        Statement(equal(combination(SUM), PRINTED)),
        spoilt=Statement(equal(combination(SUM), Q)),
        corrected=Statement(equal(combination(SUM), Q)),
        note="The entry below left is −c+id, the negative conjugate of c+id.",
    ),
    Claim(
        "C1.4.3-e",
        "matrix-determinant",
        "claim",
        "The determinant of this matrix is a²+b²+c²+d² = N(q)",
        "wyznacznik = a²+b²+c²+d²",
        Statement(f"{det(PRINTED)} == norm(q)"),
        spoilt=Statement(f"{det(Q)} == norm(q)"),
        corrected=Statement(f"{det(Q)} == norm(q)"),
        note="The matrix as printed has the determinant a²+b²−c²−d²; with −c+id it is N(q).",
    ),
    Claim(
        "C1.4.3-f",
        "matrix-conjugate",
        "formula",
        "The matrix of the conjugate",
        "q̄ = [[a−bi, −c−di],[c−di, a+bi]]",
        Statement(equal(matrix("conj(q)"), CONJUGATE)),
        spoilt=Statement(equal(matrix("conj(q)"), PRINTED)),
    ),
    Claim(
        "C1.4.3-g",
        "matrix-adjoint",
        "formula",
        "The Hermitian adjoint of the printed q equals the matrix of the conjugate",
        "[[a+ib,c+id],[c−id,a−ib]]† = [[a−bi,−c−di],[c−di,a+bi]]",
        Statement(equal(adjoint(PRINTED), CONJUGATE)),
        spoilt=Statement(equal(adjoint(Q), CONJUGATE)),
        corrected=Statement(equal(adjoint(Q), CONJUGATE)),
        note="The adjoint of the printed matrix has c+id above right; with −c+id the formula holds.",
    ),
    Claim(
        "C1.4.3-h",
        "conjugate-is-adjoint",
        "claim",
        "q̄ = q†",
        "q̄ = q†",
        Statement(equal(matrix("conj(q)"), adjoint(Q))),
        spoilt=Statement(equal(matrix("q"), adjoint(Q))),
        note="Read for the matrices of V.",
    ),
    Claim(
        "C1.4.3-i",
        "matrix-inverse-formula",
        "formula",
        "q^{-1}=1/det · [[z̄,−w],[w̄,z]]",
        "(as stated)",
        Statement(f"norm(q) != 0 => {equal(times(Q, INVERSE), E)}"),
        spoilt=Statement(f"norm(q) != 0 => {equal(times(Q, adjoint(INVERSE)), E)}"),
    ),
    Claim(
        "C1.4.3-j",
        "matrix-inverse",
        "claim",
        "The inverse quaternion is the inverse matrix",
        "wystarczy obliczyć macierz odwrotną",
        Statement(f"norm(q) != 0 => {equal(times(Q, matrix('inv(q)')), E)}"),
        spoilt=Statement(f"norm(q) != 0 => {equal(times(Q, matrix('conj(q)')), E)}"),
    ),
)
