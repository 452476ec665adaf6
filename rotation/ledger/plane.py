"""Sections 2.1 and 2.1.1: polar coordinates, the rotation of the plane, SO(2).

An angle is the point (cos θ, sin θ) of the circle c² + s² = 1, so that most of this has an algebraic
core over every commutative ring. The sum of two angles is the product (c + s·i)(c' + s'·i) of such
points: the addition formulas. ``y`` and ``s`` are the cosine and the sine where one angle is enough.
"""

from hfield.certificates.theorems import CIRCLE
from hfield.ledger.claim import Claim
from hfield.ledger.propositions import Every, Only, Statement
from hfield.ledger.real import REAL, Angles
from rotation.ledger import theorem5
from rotation.ledger.entries import (
    Matrix,
    apply,
    both,
    coordinates,
    det,
    equal,
    general,
    identity,
    matrix,
    negative,
    orthogonal,
    symmetric,
    times,
    transpose,
)

POINT = coordinates("p", 2)
ON_CIRCLE = "y**2 + s**2 == 1"
TURNED = ("p[0]*y - p[1]*s", "p[0]*s + p[1]*y")


def rotation(c: str, s: str) -> Matrix:
    """Return the matrix of the rotation by the angle whose point is (c, s)."""
    return ((c, negative(s)), (s, c))


def special(m: Matrix) -> str:
    """Return the statement that m is in SO(n)."""
    return both(orthogonal(m), f"{det(m)} == 1")


A = general("p")
B = general("q")
NORMAL = both(
    symmetric(times(A, transpose(A)), times(identity(2), transpose(A), A)), f"{det(A)} == 1"
)
TURNING = matrix("p[0], -p[2]; p[2], p[0]")  # [[a11, −a21], [a21, a11]]
COLUMNS_TOO = Statement(
    f"{special(A)} => {orthogonal(transpose(A))}",
    words="AAᵗ = I and det A = 1 make AᵗA = I (n = 2)",
)
THEOREM_4 = f"{special(A)} => {equal(A, TURNING)} and p[0]**2 + p[2]**2 == 1"
PRINTED_FORM = f"{special(A)} => {equal(A, matrix('p[0], -p[1]; p[1], p[0]'))}"
MENDED_FORM = f"{special(A)} => {equal(A, TURNING)}"
ANGLE_FOUND = (
    f"{special(A)} => {det(transpose(A))} == 1 and {det(A)} == p[0]**2 + p[1]**2"
    " and p[0]**2 + p[1]**2 == 1"
)
GROUP = both(special(times(A, B)), special(transpose(A)), special(identity(2)))

# With a radius z = q₀² ≥ 0 and a cosine y = q₁² ≥ 0, as arctg has its values between −π/2 and π/2.
ARCTG = (
    f"z == q[0]**2 and z**2 == p[0]**2 + p[1]**2 and y == q[1]**2 and {ON_CIRCLE} and "
    "s/y == p[1]/p[0]"
)
POLAR = "p[0] == z*y and p[1] == z*s"
ANGLE_OF_POINT = (
    "z**2 == p[0]**2 + p[1]**2 and z != 0 => "
    "p[0] == z*(p[0]/z) and p[1] == z*(p[1]/z) and (p[0]/z)**2 + (p[1]/z)**2 == 1"
)
# p = (x, y), the angle θ of p is (r₀, r₁), ψ is (q₀, q₁), the radius is s.
SUM_OF_ANGLES = (
    "p[0] == s*r[0] and p[1] == s*r[1] => "
    "s*(r[0] + r[1]*i)*(q[0] + q[1]*i) == s*(r[0]*q[0] - r[1]*q[1]) + s*(r[1]*q[0] + r[0]*q[1])*i"
    " and s*(r[0]*q[0] - r[1]*q[1]) == (s*r[0])*q[0] - (s*r[1])*q[1]"
    " and (s*r[0])*q[0] - (s*r[1])*q[1] == p[0]*q[0] - p[1]*q[1]"
    " and s*(r[1]*q[0] + r[0]*q[1]) == (s*r[1])*q[0] + (s*r[0])*q[1]"
    " and (s*r[1])*q[0] + (s*r[0])*q[1] == p[0]*q[1] + p[1]*q[0]"
)

# v ↦ p·v with |p| = 1 keeps lengths, and can be joined to the identity: it lies in SO(4). A vector
# that it leaves where it is makes p − 1 a divisor of 0.
FOUR = Statement("norm(p) == 1 => norm(p - 1) == 0")
TWO_AND_THREE = (Statement(THEOREM_4), theorem5.SO3_IS_COFACTORS, theorem5.FIXED_VECTOR)
EVERY_N = (
    "for n = 2, 3 and 4, every A in SO(n) is a rotation: it fixes all vectors but those of a plane"
)
UP_TO_3 = (
    "for n = 2 and 3, every A in SO(n) is a rotation: it fixes all vectors but those of a plane"
)
REAL_SPACE = "Rotations of the real space are meant."

CLAIMS = (
    Claim(
        "C2.1-a",
        "polar-coordinates",
        "formula",
        "Polar: r=√(x²+y²), θ=arctg(y/x)",
        "θ = arctg y/x",
        Only(
            Statement(
                f"{ARCTG} => {POLAR}",
                words="r = √(x² + y²) and θ = arctg y/x make x = r cos θ and y = r sin θ",
            ),
            (REAL,),
            "arctg is a real function.",
            (CIRCLE,),
        ),
        spoilt=Only(
            Statement(f"{ARCTG} => z**2*y**2 == p[0]**2"), (REAL,), "arctg is a real function."
        ),
        corrected=Angles(
            Statement(
                ANGLE_OF_POINT,
                words="if r² = x² + y² and r ≠ 0, then x = r cos θ and y = r sin θ for the angle θ of "
                "the point (x/r, y/r) of the circle",
            )
        ),
        note="arctg y/x is an angle of (x,y) only for x > 0: (−1,0) gets the angle 0. The angle of a "
        "point other than 0 is that of (x/r, y/r): arctg y/x + π for x < 0, ±π/2 for x = 0. In the "
        "witness (p0, p1) is the point, z is r, and (y, s) is (cos θ, sin θ).",
    ),
    Claim(
        "C2.1-b",
        "cartesian-coordinates",
        "formula",
        "x=r cosθ, y=r sinθ",
        "x = r cos θ, y = r sin θ",
        Statement(f"{ON_CIRCLE} and {POLAR} => p[0]**2 + p[1]**2 == z**2 and p[0]*s == p[1]*y"),
        spoilt=Statement(
            f"{ON_CIRCLE} and {POLAR} => p[0]**2 + p[1]**2 == z**2 and p[0]*y == p[1]*s"
        ),
        note="The point so given has the distance r from 0 and lies in the direction θ.",
    ),
    Claim(
        "C2.1-c",
        "plane-rotation",
        "formula",
        "x_Δ=x cosψ−y sinψ; y_Δ=x sinψ+y cosψ (rotation by ψ)",
        "x_Δ = r cos(θ+ψ) = … = x cos ψ − y sin ψ, y_Δ = r sin(θ+ψ) = … = x sin ψ + y cos ψ",
        Statement(
            SUM_OF_ANGLES,
            words="x = r cos θ and y = r sin θ make r cos(θ+ψ) = x cos ψ − y sin ψ and r sin(θ+ψ) = "
            "x sin ψ + y cos ψ, by the steps printed",
        ),
        spoilt=Statement(SUM_OF_ANGLES.replace("p[0]*q[1] + p[1]*q[0]", "p[0]*q[1] - p[1]*q[0]")),
    ),
    Claim(
        "C2.1.1-a",
        "plane-rotation-matrix",
        "definition",
        "R_2(ψ)=[[cosψ,−sinψ],[sinψ,cosψ]]",
        "R2(ψ)",
        Statement(equal(apply(rotation("y", "s"), POINT), TURNED)),
        spoilt=Statement(equal(apply(transpose(rotation("y", "s")), POINT), TURNED)),
    ),
    Claim(
        "C2.1.1-b",
        "special-orthogonal",
        "definition 5",
        "SO(n): AA^t = I_n A^tA, det 1",
        "AA^t = I_n A^t A",
        Statement(
            f"{NORMAL} => {orthogonal(A)}",
            words="AAᵗ = I·AᵗA and det A = 1 make AAᵗ = I (n = 2)",
        ),
        spoilt=COLUMNS_TOO,
        corrected=COLUMNS_TOO,
        note="A sign of equality is lost: AAᵗ = I_nAᵗA says that A commutes with Aᵗ, as every "
        "symmetric matrix does. AAᵗ = I_n = AᵗA is meant. Decided for n = 2, A = [[p0, p1],[p2, p3]].",
    ),
    Claim(
        "C2.1.1-c",
        "so-n-group",
        "definition 5",
        "“special orthogonal group of R^n, SO(n)”",
        "SO(n)",
        Statement(
            f"{special(A)} and {special(B)} => {GROUP}",
            words="SO(2) has I, the products of its elements and their inverses",
        ),
        spoilt=Statement(f"{special(A)} and {orthogonal(B)} => {GROUP}"),
        note="It is a group: closed under products and inverses. Decided for n = 2, AAᵗ = I_n.",
    ),
    Claim(
        "C2.1.1-d",
        "so-n-rotations",
        "claim",
        "Every element of SO(n) is a rotation by some angle in R^n",
        "każda macierz SO(n) jest opisem obrotu o pewien kąt",
        Only(Every((*TWO_AND_THREE, FOUR), EVERY_N), (REAL,), REAL_SPACE, (CIRCLE,)),
        spoilt=Only(Every(TWO_AND_THREE, UP_TO_3), (REAL,), REAL_SPACE, (CIRCLE,)),
        corrected=Only(Every(TWO_AND_THREE, UP_TO_3), (REAL,), REAL_SPACE, (CIRCLE,)),
        note="A rotation by one angle turns a plane and fixes what is perpendicular to it, so for "
        "n = 4 it fixes some vectors; but v ↦ −v is in SO(4), and fixes none but 0.",
    ),
    Claim(
        "C2.1.1-e",
        "theorem-4",
        "theorem 4",
        "A∈SO(2) ⇒ A is a rotation matrix",
        "A∈SO(2)",
        Angles(
            Statement(THEOREM_4, words="every A in SO(2) is [[c, −s], [s, c]] with c² + s² = 1")
        ),
        spoilt=Angles(Statement(THEOREM_4.replace(f" and {det(A)} == 1", ""))),
        headline=True,
        note="Read with AAᵗ = I_n, the slip of Definition 5 being charged to C2.1.1-b.",
    ),
    Claim(
        "C2.1.1-f",
        "theorem-4-form",
        "proof",
        "A^t=A^{-1} and det=1 ⇒ form [[a11,−a12],[a12,a11]]",
        "[[a11, −a12],[a12, a11]]",
        Statement(PRINTED_FORM, words="A ∈ SO(2) is [[a11, −a12], [a12, a11]]"),
        spoilt=Statement(MENDED_FORM),
        corrected=Statement(MENDED_FORM, words="A ∈ SO(2) is [[a11, −a21], [a21, a11]]"),
        note="In A = [a_ij] the entry above right is a12, and cannot be −a12: the form is "
        "[[a11, −a21],[a21, a11]]. Here A is [[p0, p1],[p2, p3]].",
    ),
    Claim(
        "C2.1.1-g",
        "theorem-4-angle",
        "proof",
        "det A = det A^t = det A^{-1} = 1, det = a11²+a12²=1 ⇒ ψ exists",
        "a11=cosψ, a12=sinψ",
        Angles(
            Statement(ANGLE_FOUND, words="A ∈ SO(2) makes det Aᵗ = 1 and det A = a11² + a12² = 1")
        ),
        spoilt=Angles(Statement(ANGLE_FOUND.replace("p[1]**2 == 1", "p[3]**2 == 1"))),
        note="A⁻¹ is Aᵗ. With a12 = sin ψ, and not a21, A is the rotation by −ψ.",
    ),
)
