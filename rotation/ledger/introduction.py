"""The introduction: what it announces, read with what the chapters say of it.

The entries of a 2 × 2 matrix are the coordinates of q, row by row. That (a, b) with a² + b² = 1 is
the cosine and the sine of an angle is how chapter 2 reads it; over every field it is a point of the
unit circle.
"""

from hfield.ledger.claim import Claim
from hfield.ledger.propositions import Every, Statement

ORTHOGONAL = (
    "q[0]**2 + q[1]**2 == 1",
    "q[2]**2 + q[3]**2 == 1",
    "q[0]*q[2] + q[1]*q[3] == 0",
)
DETERMINANT = "q[0]*q[3] - q[1]*q[2]"
ROTATION = "q[0] == q[3] and q[1] == -q[2] and q[0]**2 + q[2]**2 == 1"
REFLECTION = "q[0] == -q[3] and q[1] == q[2] and q[0]**2 + q[2]**2 == 1"

# The quaternion q has modulus 1; p, and in the second part v, are points.
MODULUS = "norm(q) == 1"
POINT = "scalar(p) == 0"
TURNED = "q*p*conj(q)"
ONE_SIDED = Statement("scalar(q*p) == 0 and norm(q*p) == norm(p)", (MODULUS, POINT))
TWO_SIDED = Every(
    (
        Statement(f"scalar({TURNED}) == 0 and norm({TURNED}) == norm(p)", (MODULUS, POINT)),
        Statement(f"{TURNED}*(q*v*conj(q)) == q*(p*v)*conj(q)", (MODULUS,)),
    )
)


def orthogonal(determinant: str, form: str) -> Statement:
    """Say that orthogonal 2 × 2 matrices with this determinant have a form."""
    return Statement(form, (*ORTHOGONAL, f"{DETERMINANT} == {determinant}"))


CLAIMS = (
    Claim(
        "C0-a",
        "history",
        "fact",
        "Hamilton, an Irishman, introduced the quaternions in 1843",
        "w roku 1843",
        note="History.",
        fieldless=True,
    ),
    Claim(
        "C0-b",
        "plane-rotations",
        "claim",
        "Every orthogonal matrix of determinant 1 is a rotation by some angle (in the plane)",
        "każda macierz ortogonalna o wyznaczniku równym 1 jest macierzą obrotu o pewien kąt",
        orthogonal("1", ROTATION),
        spoilt=orthogonal("-1", ROTATION),
        note="Its first column is a point of the unit circle, hence the cosine and sine of an angle.",
    ),
    Claim(
        "C0-c",
        "one-sided-product",
        "claim",
        "A rotation in space is the product of the point and a quaternion of modulus 1",
        "obrotu jako wynik mnożenia punktu przez kwaternion o module równym jeden",
        ONE_SIDED,
        spoilt=TWO_SIDED,
        corrected=TWO_SIDED,
        note="The product q·p of a point p leaves space. It is q·p·q̄ that stays in it, keeps lengths, "
        "and respects products, hence also orientation.",
    ),
    Claim(
        "C0-d",
        "rotation-named-twice",
        "terminology",
        "The examples show a rotation matrix (“macierz obrotu”) and a rotation matrix (“macierz rotacji”)",
        "macierzy obrotu i macierzy rotacji",
        orthogonal("-1", ROTATION),
        spoilt=orthogonal("-1", REFLECTION),
        corrected=orthogonal("-1", REFLECTION),
        note="The matrices of the second example are orthogonal of determinant −1: reflections (“macierz "
        "odbicia”), and no rotations unless 2 = 0.",
    ),
    Claim(
        "C0-e",
        "points-of-the-model",
        "number",
        "550 thousand points imitate the model Aloy of “Horizont: Zero Down”",
        "550 tys. punktów ... Horizont: Zero Down",
        note="A fact about a game, whose title is Horizon Zero Dawn.",
        fieldless=True,
    ),
)
