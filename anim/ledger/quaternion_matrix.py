"""Section 3.4.4: the matrix of a unit quaternion, and the function that computes it.

q = a + bi + cj + dk, and v a point. The function is run on terms.
"""

from anim.ledger.counting import takes
from hfield.ledger.document import Propositions
from hfield.ledger.propositions import Assertion, Every
from hfield.syntax import Node, both, conj, equal, names, norm, unequal
from rotation.ledger.entries import Matrix, matrix, orthogonal, transpose
from rotation.ledger.symbolic_runs import code, coordinates, point, read_as

QUATERNION, ANY, S, T, Y, ANGLE = names("q p s t y angle")
LETTERS = {ord(letter): f"q[{n}]" for n, letter in enumerate("abcd")}


def quaternion_matrix(sixth: str) -> Matrix:
    """Return the matrix of a quaternion, with ``sixth`` as the entry in the second row and third column."""
    rows = (
        "a**2 + b**2 - c**2 - d**2, 2*(b*c - a*d), 2*(b*d + a*c);"
        f"2*(b*c + a*d), a**2 - b**2 + c**2 - d**2, {sixth};"
        "2*(b*d - a*c), 2*(c*d + a*b), a**2 - b**2 - c**2 + d**2"
    )
    return matrix(rows.translate(LETTERS))


PRINTED = quaternion_matrix("2*(c*d + a*b)")
MENDED = quaternion_matrix("2*(c*d - a*b)")
UNIT = ("norm(q) == 1",)


def turns(m: Matrix, sixth: str) -> Assertion:
    """Return the claim that a matrix rotates i, j and k, hence every point, like the unit quaternion q.

    ``sixth`` names its sixth entry.
    """
    columns = zip(names("i j k"), transpose(m), strict=True)
    turned = [
        equal(point(column), QUATERNION * unit * conj(QUATERNION)) for unit, column in columns
    ]
    words = f"if |q| = 1, the matrix with {sixth} takes every point x to q·x·q̄"
    return Assertion.of(both(*turned), UNIT, words)


def is_orthogonal(m: Matrix, sixth: str) -> Assertion:
    """Return the claim that a matrix of the unit quaternion q is orthogonal; ``sixth`` names its
    sixth entry.
    """
    return Assertion.of(orthogonal(m), UNIT, f"if |q| = 1, the matrix with {sixth} is orthogonal")


EQUAL = ("q[1] == q[0]", "q[2] == q[0]", "q[3] == q[0]")


def above_all(claim: Assertion) -> Every:
    """Return the claim, preceded by a special case: unit quaternions with four equal coordinates.

    If the claim is false the special case shows it, even over fields with few unit quaternions.
    """
    return Every((Assertion(claim.formula, (*EQUAL, *claim.given)), claim), claim.text)


# rotationMatrixFromQuaternion(angle, p): s and t are the cosine and sine of half the angle, y the length
# of the vector part of p.
P, V = coordinates("p"), coordinates("v")
READ = {
    "cos": read_as({"0.5*angle": "s"}),
    "sin": read_as({"0.5*angle": "t"}),
    "sqrt": lambda square: Y,
}
MATRIX = code("rotationMatrixFromQuaternion", **READ)(ANGLE, P)
TURNED = point(code("rotationbyMatrix")(MATRIX, V))
CIRCLE = "s**2 + t**2 == 1"
LENGTH = (equal(Y**2, norm(point(P))), unequal(Y, 0))


def made_of(h: Node, words: str, *given: str) -> Assertion:
    """Return the claim that the function's matrix rotates points like a quaternion."""
    return Assertion.of(equal(TURNED, h * point(V) * conj(h)), (*LENGTH, *given), words)


NORMALISED = made_of(
    S + T / Y * point(P),
    "rotationMatrixFromQuaternion(angle, p)·x = h·x·h̄ for h = cos(angle/2) + sin(angle/2)·p/|p|",
    CIRCLE,
)
UNNORMALISED = made_of(S + T * point(P), "the same for h = cos(angle/2) + sin(angle/2)·p", CIRCLE)

# The scalar part of the product in the place of the angle. For the scalar part 0 the cosine of half the
# "angle" 0 is s = 1, the sine t = 0.
AS_ANGLE = made_of(
    ANY,
    "rotationMatrixFromQuaternion(Sc p, Vec p)·x = p·x·p̄ for |p| = 1 and Sc p = 0",
    *("norm(p) == 1", "p[0] == 0", "s == 1", "t == 0"),
)
OF_ANGLE = made_of(
    ANY,
    "rotationMatrixFromQuaternion(angle, Vec p)·x = p·x·p̄ for |p| = 1, Vec p ≠ 0 and "
    "cos(angle/2) = Sc p, sin(angle/2) = |Vec p|",
    *("norm(p) == 1", "s == p[0]", "t == y"),
)

COMPUTED = {
    "C3.4.4-a": Propositions(
        as_printed=above_all(turns(PRINTED, "2(cd + ab)")),
        spoilt=turns(MENDED, "2(cd − ab)"),
        corrected=turns(MENDED, "2(cd − ab)"),
    ),
    "C3.4.4-a2": Propositions(
        as_printed=above_all(is_orthogonal(PRINTED, "2(cd + ab)")),
        spoilt=is_orthogonal(MENDED, "2(cd − ab)"),
        corrected=is_orthogonal(MENDED, "2(cd − ab)"),
    ),
    "C3.4.4-b": Propositions(
        as_printed=takes("rotationMatrixFromQuaternion", 2),
        spoilt=takes("rotationMatrixFromQuaternion", 3),
    ),
    "C3.4.4-c": Propositions(as_printed=NORMALISED, spoilt=UNNORMALISED),
    "C3.4.4-d": Propositions(as_printed=AS_ANGLE, spoilt=OF_ANGLE, corrected=OF_ANGLE),
}
