"""Section 2.2.4, Theorem 5: every R in SO(3) is a rotation, with its axis and its angle.

The core holds over every commutative ring. Let R be in SO(3), so that R is its own matrix of cofactors, let t
be its trace and W = (r32 − r23, r13 − r31, r21 − r12). Then det(R − I) = 0, so that a vector is fixed; RW =
W; W∘W = (1 + t)(3 − t); and (1 + t)(R + Rᵗ) = (t² − 1)I + WWᵗ. If 2(1 + t) is a unit, let c = (t − 1)/2 and w
= W/2. Then the last equation is Rodrigues' formula for the angle with cosine c, the axis w and the sine |w|,
and the equation before it says that c² + |w|² = 1.

Over RR the case t = −1 remains. Then W∘W = 0 implies W = 0, so R is symmetric, and the minors of R + I are
those of R − Rᵗ + (1 + t)I = 0. So R + I has rank one, and one of its columns, divided by its length (every
norm is a square), is the axis of a half turn.
"""

from hfield.ledger.document import Propositions
from hfield.ledger.linear_algebra import IsBasis
from hfield.ledger.modulus import ModulusDefined
from hfield.ledger.propositions import Assertion, Every
from hfield.ledger.real_geometry import Angles
from hfield.syntax import Node, both, implies
from hfield.syntax import equal as same
from rotation.ledger.entries import (
    ONE,
    ZERO,
    Matrix,
    apply,
    cofactors,
    coordinates,
    det,
    difference,
    dot,
    equal,
    general,
    identity,
    orthogonal,
    plus,
    scaled,
    shifted,
    symmetric,
    times,
    trace,
    transpose,
)

R = general("pqr")
ORTHOGONAL, DETERMINANT = orthogonal(R), same(det(R), 1)
OWN_COFACTORS = equal(cofactors(R), R)
T = trace(R)
W = (
    difference(R[2][1], R[1][2]),
    difference(R[0][2], R[2][0]),
    difference(R[1][0], R[0][1]),
)


TWICE_SYMMETRIC = tuple(tuple((1 + T) * (R[r][c] + R[c][r]) for c in range(3)) for r in range(3))
RODRIGUES = shifted(tuple(tuple(x * y for y in W) for x in W), T**2 - 1)
# The minors of R + I are entries of R − Rᵗ, and on the diagonal 1 + t.
SKEW = shifted(
    tuple(tuple(difference(R[r][c], R[c][r]) for c in range(3)) for r in range(3)), 1 + T
)

SO3_IS_COFACTORS = Assertion.of(
    implies(both(ORTHOGONAL, DETERMINANT), OWN_COFACTORS),
    words="R ∈ SO(3) is its own matrix of cofactors",
)
FIXED_VECTOR = Assertion.of(
    implies(both(DETERMINANT, OWN_COFACTORS), same(det(shifted(R, -ONE)), 0)),
    words="if det R = 1 and R is its own matrix of cofactors, det(R − I) = 0",
)
SO3_COLUMNS = Assertion.of(
    implies(both(ORTHOGONAL, DETERMINANT, OWN_COFACTORS), orthogonal(transpose(R))),
    words="R ∈ SO(3) makes RᵗR = I",
)
AXIS_AND_ANGLE = Assertion.of(
    implies(
        both(ORTHOGONAL, OWN_COFACTORS),
        both(
            equal(apply(R, W), W),
            same(dot(W, W), (1 + T) * (3 - T)),
            symmetric(TWICE_SYMMETRIC, RODRIGUES),
        ),
    ),
    words="RW = W, W∘W = (1 + t)(3 − t) and (1 + t)(R + Rᵗ) = (t² − 1)I + WWᵗ, where t = tr R",
)
CORE = Every(
    (SO3_IS_COFACTORS, FIXED_VECTOR, AXIS_AND_ANGLE),
    "R ∈ SO(3) fixes a vector; it turns about W = (r32−r23, r13−r31, r21−r12) with 2·cos θ = tr R − 1",
)
NO_SQUARES = "p[1]**2 + p[2]**2 + p[3]**2 == 0 => p[1] == 0 and p[2] == 0 and p[3] == 0"
HALF_TURN = implies(OWN_COFACTORS, equal(cofactors(shifted(R, ONE)), SKEW))
REAL_PART = Every(
    (
        Assertion(NO_SQUARES),
        Assertion.of(HALF_TURN, words="the minors of R + I are the entries of R − Rᵗ + (1 + t)I"),
        ModulusDefined(),
    ),
    "where t = −1, R + I has rank one and gives the axis",
)

# The orthonormal v1, v2, v3 are the vector parts of p, q, r, and the columns of B.
COLUMNS = transpose(R)
SWAPPED = (R[1], R[0], R[2])
BLOCK = general("p")
B = transpose(general("uvw"))


def bordered(corner: Node) -> Matrix:
    """Return the 3 × 3 block matrix with [[a, c], [b, d]] and the entry ``corner`` below it."""
    (a, c), (b, d) = BLOCK
    return ((a, c, ZERO), (b, d, ZERO), (ZERO, ZERO, corner))


def special(m: Matrix) -> Node:
    """Return the statement that m is in SO(n)."""
    return both(orthogonal(m), same(det(m), 1))


V1, V2, V3 = transpose(B)
IMAGES = transpose(
    (
        plus(scaled(BLOCK[0][0], V1), scaled(BLOCK[1][0], V2)),
        plus(scaled(BLOCK[0][1], V1), scaled(BLOCK[1][1], V2)),
        V3,
    )
)
E3 = ((1, 0, 0), (0, 1, 0), (0, 0, 1))
# Av1 and Av2 are perpendicular to u = v3 = Av3: since Aᵗu = AᵗAu = u, (Av)∘u = v∘(Aᵗu) = v∘u.
U, V = coordinates("u"), coordinates("v")
KEEPS_PLANE = (
    implies(
        both(orthogonal(transpose(R)), equal(apply(R, U), U)), equal(apply(transpose(R), U), U)
    ),
    same(dot(apply(R, V), U), dot(V, apply(transpose(R), U))),
)
ROWS_EXCHANGED = Assertion.of(
    same(det(SWAPPED), -det(R)), words="exchanging two rows changes the sign of det B"
)
SQUARE_OF_DETERMINANT = Assertion.of(
    both(same(det(R) ** 2, det(times(R, COLUMNS))), same(det(identity(3)), 1)),
    words="(det B)² = det BBᵗ, and det I = 1",
)
ORIENTED = Every(
    (
        SQUARE_OF_DETERMINANT,
        Assertion("s**2 == 1 => s == 1 or s == -1", words="(det B)² = 1 makes det B = ±1"),
        ROWS_EXCHANGED,
        Assertion.of(implies(ORTHOGONAL, orthogonal(SWAPPED)), words="and leaves B orthogonal"),
    ),
    "BBᵗ = I makes det B = ±1, and exchanging two rows changes the sign",
)
ANY_COLUMNS = equal(times(R, B), transpose(tuple(apply(R, v) for v in transpose(B))))
IMAGES_OF_BASIS = Every(
    (
        Assertion.of(ANY_COLUMNS, words="AB = [Av1, Av2, Av3]"),
        Assertion.of(KEEPS_PLANE[0], words="if AᵗA = I and Au = u, then Aᵗu = u"),
        Assertion.of(KEEPS_PLANE[1], words="(Av)∘u = v∘(Aᵗu)"),
    ),
    "AB = [Av1, Av2, Av3], and Av1, Av2 are perpendicular to v3 = Av3",
)
CASE_ONE = implies(special(bordered(ONE)), special(BLOCK))

COMPUTED = {
    "C2.2.4-m": Propositions(
        as_printed=Angles(CORE, REAL_PART),
        spoilt=Angles(
            Assertion.of(implies(both(DETERMINANT, OWN_COFACTORS), same(det(shifted(R, ONE)), 0)))
        ),
    ),
    "C2.2.4-n": Propositions(
        as_printed=IsBasis(
            ((1, 0, 0), (0, 1, 0), (1,)), 3, "v1, v2 ∈ R³ with a unit vector v3 ∈ R"
        ),
        spoilt=IsBasis(E3, 3, "v1, v2, v3 ∈ R³"),
        corrected=IsBasis(E3, 3, "v1, v2, v3 ∈ R³, orthonormal, such as e1, e2, e3,"),
    ),
    "C2.2.4-p": Propositions(
        as_printed=Every(
            (
                SQUARE_OF_DETERMINANT,
                ROWS_EXCHANGED,
                Assertion(
                    "s**2 == 1 and y == 1 => s == 1",
                    words="(det B)² = 1 and det A = 1 make det B = 1",
                ),
            ),
            "exchanging two rows changes the sign of det B; BBᵗ = I and det A = 1 make det B = 1",
        ),
        spoilt=ORIENTED,
        corrected=ORIENTED,
    ),
    "C2.2.4-q": Propositions(spoilt=IMAGES_OF_BASIS, corrected=IMAGES_OF_BASIS),
    "C2.2.4-r": Propositions(
        as_printed=Every(
            (
                Assertion.of(
                    equal(times(B, bordered(ONE)), IMAGES),
                    words="B·[[a, c, 0], [b, d, 0], [0, 0, 1]] = [av1 + bv2, cv1 + dv2, v3]",
                ),
                Assertion.of(
                    CASE_ONE,
                    words="if [[a, c, 0], [b, d, 0], [0, 0, 1]] is in SO(3), [[a, c], [b, d]] is in SO(2)",
                ),
            )
        )
    ),
}
