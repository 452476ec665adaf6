"""Euler angles (end of 2.2.3) and the matrix R_z(φ)R_y(θ)R_x(ψ) of section 2.2.4.

The angles φ, θ, ψ are the points (p₀, p₁), (p₂, p₃), (q₀, q₁) of the circle, and v is a point of space.
"""

from hfield.certificates.theorems import CIRCLE
from hfield.ledger.claim import Claim, Proposition
from hfield.ledger.propositions import Every, Only, Statement
from hfield.ledger.real import REAL, Angles
from hfield.ledger.roots import ModulusDefined
from rotation.ledger.entries import (
    Matrix,
    apply,
    both,
    coordinates,
    det,
    equal,
    identity,
    matrix,
    minor,
    orthogonal,
    times,
    transpose,
)
from rotation.ledger.plane import ON_CIRCLE
from rotation.ledger.space import E1, E2, E3, about_x, about_y, about_z
from rotation.ledger.theorem5 import (
    CORE,
    ORTHOGONAL,
    OWN_COFACTORS,
    REAL_PART,
    SO3_COLUMNS,
    SO3_IS_COFACTORS,
)
from rotation.ledger.theorem5 import R as ANY

ANGLES = "p[0]**2 + p[1]**2 == 1 and p[2]**2 + p[3]**2 == 1 and q[0]**2 + q[1]**2 == 1"
Z, Y, X = about_z("p[0]", "p[1]"), about_y("p[2]", "p[3]"), about_x("q[0]", "q[1]")
V = coordinates("v")

# Printed: R_y(θ)R_x(ψ), R_z(φ) in the second product, and the whole product.
PRINTED_YX = matrix("p[2], p[3]*q[1], p[3]*q[0]; 0, q[0], -q[1]; -p[3], p[2]*q[1], p[2]*q[0]")
PRINTED_Z = matrix("0, p[0], -p[1]; 0, p[1], p[0]; 0, 0, 1")
PRINTED_ZYX = matrix(
    "p[0]*p[2], p[0]*p[3]*q[1] - p[1]*q[0], p[0]*p[3]*q[0] + p[1]*q[1];"
    "p[1]*p[2], p[1]*p[3]*q[1] + p[0]*q[0], p[1]*p[3]*q[0] - p[0]*q[1];"
    "-p[3], p[2]*q[1], p[2]*q[0]"
)
ZYX = times(Z, times(Y, X))
ONE = identity(3)

# For R in SO(3) put cos θ = z, a root of r11² + r21², and y = 1/z. Where z ≠ 0, all three angles are
# read off the first column and the last row; where r11 = r21 = 0, one may take φ = 0.
FIRST, LAST = "p[1]**2 + q[1]**2 == z**2", "r[2]**2 + r[3]**2 == z**2"
TIMES_SQUARE = {  # the other four entries of R, times z²
    (0, 1): "-p[1]*r[1]*r[2] - q[1]*r[3]",
    (0, 2): "q[1]*r[2] - p[1]*r[1]*r[3]",
    (1, 1): "p[1]*r[3] - q[1]*r[1]*r[2]",
    (1, 2): "-p[1]*r[2] - q[1]*r[1]*r[3]",
}
FOUR = {at: f"z**2*{ANY[at[0]][at[1]]} == {text}" for at, text in TIMES_SQUARE.items()}
ENTRIES = (
    f"{ORTHOGONAL} and {orthogonal(transpose(ANY))} and {OWN_COFACTORS} and {FIRST}"
    f" => {LAST} and z**2 + r[1]**2 == 1 and {both(*FOUR.values())}"
)
FROM_ENTRIES = times(
    about_z("(p[1]*y)", "(q[1]*y)"), about_y("z", "-r[1]"), about_x("(r[3]*y)", "(r[2]*y)")
)
SAME = {(r, c): f"{ANY[r][c]} == {FROM_ENTRIES[r][c]}" for r in range(3) for c in range(3)}
GENERAL = (
    *(f"y*z == 1 and {FOUR[at]} => {SAME[at]}" for at in FOUR),
    f"y*z == 1 => {both(*(text for at, text in SAME.items() if at not in FOUR))}",
    f"y*z == 1 and {FIRST} => (p[1]*y)**2 + (q[1]*y)**2 == 1",
    f"y*z == 1 and {LAST} => (r[3]*y)**2 + (r[2]*y)**2 == 1",
)


def locked(sine: str) -> str:
    """Say what R is where r11 = r21 = 0, with the sine of the angle about x."""
    return (
        f"{ORTHOGONAL} and {OWN_COFACTORS} and p[1] == 0 and q[1] == 0 => "
        f"{equal(ANY, times(about_y('0', '-r[1]'), about_x('q[2]', sine)))}"
        " and r[1]**2 == 1 and q[2]**2 + q[3]**2 == 1"
    )


REAL_ANGLES = "Angles of rotations of the real space are meant."


def every_rotation(sine: str) -> Only:
    """Say that every rotation has Euler angles; ``sine`` is that about x where r11 = r21 = 0."""
    parts: tuple[Proposition, ...] = (
        SO3_IS_COFACTORS,
        SO3_COLUMNS,
        ModulusDefined(),
        Statement(ENTRIES, words="the first column and the last row give the rest, times z²"),
        *map(Statement, GENERAL),
        Statement("p[1]**2 + q[1]**2 == 0 => p[1] == 0 and q[1] == 0"),
        Statement(locked(sine), words="where r11 = r21 = 0, R is R_y(θ)R_x(γ)"),
    )
    words = "every R in SO(3) is R_z(ψ)R_y(θ)R_x(γ) for some angles ψ, θ, γ"
    return Only(Every(parts, words), (REAL,), REAL_ANGLES, (CIRCLE,))


def expanded(m: Matrix, column: int) -> str:
    """Say that Laplace's expansion along a column of m leaves the minor of a rotation of the plane."""
    left = minor(m, column, column)
    return both(
        equal(transpose(m)[column], (E1, E2, E3)[column]),
        f"{left[0][0]} == {left[1][1]} and {left[0][1]} == -({left[1][0]})",
        f"{det(left)} == 1 and {det(m)} == {det(left)}",
    )


def laplace(third: Matrix, axis: str) -> Statement:
    """Say it of R_x and the first column, R_y and the second, a third matrix and the third."""
    parts = (about_x("y", "s"), about_y("y", "s"), third)
    return Statement(
        f"{ON_CIRCLE} => {both(*(expanded(m, n) for n, m in enumerate(parts)))}",
        words=f"expanded along columns 1, 2 and 3, R_x, R_y and R_{axis} leave the minors of rotations of "
        "the plane, and have the determinant 1",
    )


def inverses(*axes: Matrix) -> Statement:
    """Say that the transposed matrices are inverse to those given, on both sides."""
    sides = both(*(both(orthogonal(m), orthogonal(transpose(m))) for m in axes))
    return Statement(
        f"{ANGLES} => {sides}", words="the transposes of R_x, R_y, R_z are their inverses"
    )


PRODUCT_IS_I = Statement(f"{ANGLES} => {orthogonal(PRINTED_ZYX)}", words="R_zyx·R_zyxᵗ = I")
FIRST_X = Statement(
    equal(apply(Z, apply(Y, apply(X, V))), apply(PRINTED_ZYX, V)),
    words="turning by ψ about x, then by θ about y, then by φ about z is R_z(φ)R_y(θ)R_x(ψ)",
)
MENDED_Z = Statement(
    equal(times(Z, PRINTED_YX), PRINTED_ZYX),
    words="[[cosφ, −sinφ, 0], [sinφ, cosφ, 0], [0, 0, 1]]·R_y(θ)R_x(ψ) is the matrix printed after it",
)
DETERMINANT = f"{ANGLES} => {det(PRINTED_ZYX)} == ({det(Z)})*({det(Y)})*({det(X)})"
UNCHANGED = both(
    equal(about_z("p[0]", "p[1]"), times(Z, ONE, ONE)),
    equal(times(about_z("1", "0"), Y, about_x("1", "0")), Y),
    equal(times(about_z("1", "0"), about_y("1", "0"), X), X),
    equal(times(Z, Y, X), PRINTED_ZYX),
)

CLAIMS = (
    Claim(
        "C2.2.3-e",
        "euler-angles",
        "claim",
        "any 3D rotation = triple (ψ about z, θ about y, γ about x) “Euler angle”",
        "(ψ,θ,γ)",
        every_rotation("-q[3]"),
        spoilt=every_rotation("q[3]"),
        note="In the order of 2.2.4, R_z(ψ)R_y(θ)R_x(γ). The triple is not unique: where cos θ = 0 "
        "only the sum or difference of ψ and γ counts (gimbal lock).",
    ),
    Claim(
        "C2.2.4-a",
        "arbitrary-axis",
        "title",
        "“Rotation matrix about an arbitrary axis”",
        "—",
        note="A title, and not what follows: the matrix computed is that of three Euler angles. The "
        "matrix for an axis u and an angle is Rodrigues' formula, behind C2.2.4-m and C2.2.5-e.",
    ),
    Claim(
        "C2.2.4-b",
        "order-of-euler-angles",
        "claim",
        "first φ about z, then θ about y, finally ψ about x — computed as R_z R_y R_x",
        "R_z(φ)R_y(θ)R_x(ψ)",
        Statement(
            f"{ANGLES} => {equal(times(X, Y, Z), ZYX)}",
            words="turning by φ about z, then by θ about y, then by ψ about x is R_z(φ)R_y(θ)R_x(ψ)",
        ),
        spoilt=FIRST_X,
        corrected=FIRST_X,
        note="As in Example 4, what is done first stands on the right: R_zR_yR_x turns a point first "
        "about x, then about y, then about z. (About axes that turn along, it is z, y, x.)",
    ),
    Claim(
        "C2.2.4-c",
        "product-of-y-and-x",
        "formula",
        "R_y(θ)R_x(ψ)",
        "[[cosθ, sinθ sinψ, sinθ cosψ],[0,cosψ,−sinψ],[−sinθ, cosθ sinψ, cosθ cosψ]]",
        Statement(equal(times(Y, X), PRINTED_YX), words="R_y(θ)R_x(ψ) is the matrix printed"),
        spoilt=Statement(equal(times(X, Y), PRINTED_YX)),
    ),
    Claim(
        "C2.2.4-d",
        "matrix-about-z-again",
        "formula",
        "R_z(φ) as printed in the second product",
        "[[0,cosφ,−sinφ],[0,sinφ,cosφ],[0,0,1]]",
        Statement(
            f"{ON_CIRCLE} => {equal(matrix('0, y, -s; 0, s, y; 0, 0, 1'), about_z('y', 's'))}",
            words="R_z(φ) is [[0, cosφ, −sinφ], [0, sinφ, cosφ], [0, 0, 1]]",
        ),
        spoilt=MENDED_Z,
        corrected=MENDED_Z,
        note="The columns have slipped to the right: it is [[cosφ,−sinφ,0],[sinφ,cosφ,0],[0,0,1]], "
        "with which the product is the one printed after it.",
    ),
    Claim(
        "C2.2.4-e",
        "euler-matrix",
        "formula",
        "final 3×3 matrix R_{zyx}",
        "[[cosφcosθ, cosφsinθsinψ−sinφcosψ, cosφsinθcosψ+sinφsinψ],[sinφcosθ, "
        "sinφsinθsinψ+cosφcosψ, sinφsinθcosψ−cosφsinψ],[−sinθ, cosθsinψ, cosθcosψ]]",
        Statement(equal(ZYX, PRINTED_ZYX), words="R_z(φ)R_y(θ)R_x(ψ) is the matrix printed"),
        spoilt=Statement(equal(times(PRINTED_Z, PRINTED_YX), PRINTED_ZYX)),
        headline=True,
    ),
    Claim(
        "C2.2.4-f",
        "matrix-of-euler-angles",
        "claim",
        "R_zyx is the rotation for Euler angle (φ,θ,ψ)",
        "(φ,θ,ψ)",
        Statement(
            UNCHANGED,
            words="where two of the angles are 0, R_z(φ)R_y(θ)R_x(ψ) is the rotation by the third about "
            "its axis; and it is the matrix printed",
        ),
        spoilt=Statement(equal(times(X, Y, Z), PRINTED_ZYX)),
        note="φ is the angle about z, θ about y, ψ about x: where two of them are 0, the rotation "
        "about the third axis is left.",
    ),
    Claim(
        "C2.2.4-g",
        "laplace-expansion",
        "claim",
        "Laplace expansion: each det 1; “axes x, y and x”; minors are plane rotation matrices",
        "osi x, y oraz x … 1,2,3 kolumna",
        laplace(about_x("y", "s"), "x"),
        spoilt=laplace(about_z("y", "s"), "z"),
        corrected=laplace(about_z("y", "s"), "z"),
        note="The third axis is z: the third column of R_x has two entries that are not 0.",
    ),
    Claim(
        "C2.2.4-h",
        "euler-determinant",
        "formula",
        "det(R_zyx)=1",
        "det(R_z)det(R_y)det(R_x) = 1",
        Statement(
            f"{DETERMINANT} and {det(PRINTED_ZYX)} == 1",
            words="the determinant of R_zyx is the product of those of R_z, R_y and R_x, and is 1",
        ),
        spoilt=Statement(f"{DETERMINANT} and {det(PRINTED_ZYX)} == -1"),
    ),
    Claim(
        "C2.2.4-i",
        "euler-transpose",
        "formula",
        "R R^T = I_n",
        "I_n",
        PRODUCT_IS_I,
        spoilt=Statement(f"{ANGLES} => {equal(times(PRINTED_ZYX, PRINTED_ZYX), ONE)}"),
        note="The n is 3.",
    ),
    Claim(
        "C2.2.4-i2",
        "inverse-is-transpose",
        "claim",
        "R_x,R_y,R_z: inverse = transpose",
        "macierzami odwrotnymi … są ich macierze transponowane",
        inverses(X, Y, Z),
        spoilt=inverses(X, Y, ((Z[0][0], Z[0][0], "0"), Z[1], Z[2])),
    ),
    Claim(
        "C2.2.4-j",
        "euler-so3",
        "claim",
        "R_zyx ∈ SO(3); inclusion holds the other way too",
        "SO(3)",
        Angles(
            Every(
                (
                    PRODUCT_IS_I,
                    Statement(f"{ANGLES} => {det(PRINTED_ZYX)} == 1", words="det R_zyx = 1"),
                    CORE,
                ),
                f"R_zyx is in SO(3), and {CORE.text}",
            ),
            REAL_PART,
        ),
        spoilt=Angles(Statement(f"{ANGLES} => {equal(PRINTED_ZYX, transpose(PRINTED_ZYX))}")),
        note="The other inclusion is Theorem 5 (C2.2.4-m); C2.2.3-e gives the Euler angles.",
    ),
)
