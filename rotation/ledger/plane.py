"""Sections 2.1 and 2.1.1: polar coordinates, the rotation of the plane, SO(2).

An angle is the point (cos θ, sin θ) of the circle c² + s² = 1, so most of this has an algebraic core over
every commutative ring. The sum of two angles is the product (c + s·i)(c' + s'·i) of the points (the addition
formulas). ``y`` and ``s`` are the cosine and the sine if there is only one angle.
"""

from hfield.checker.glossary import CIRCLE
from hfield.ledger.document import Propositions
from hfield.ledger.propositions import Assertion, Every
from hfield.ledger.real_geometry import REAL, Angles
from hfield.ledger.scopes import OnlyOver
from hfield.syntax import Node, both, implies
from hfield.syntax import equal as same
from rotation.ledger import theorem5
from rotation.ledger.entries import (
    det,
    equal,
    general,
    matrix,
    orthogonal,
    transpose,
)

ON_CIRCLE = "y**2 + s**2 == 1"


A = general("p")
TURNING = matrix("p[0], -p[2]; p[2], p[0]")  # [[a11, −a21], [a21, a11]]
ON_UNIT_CIRCLE = "p[0]**2 + p[2]**2 == 1"
FIRST_COLUMN = both(equal(A, TURNING), ON_UNIT_CIRCLE)
THEOREM_4 = implies(theorem5.special(A), FIRST_COLUMN)


def angle_found(other: int) -> Node:
    """Return the claim that det Aᵗ = 1, det A = a11² + a12², and a11² plus the square of another
    entry is 1.
    """
    (a, b), _ = A
    p = (a, b, *A[1])
    length = same(det(A), a**2 + b**2)
    ends = both(same(det(transpose(A)), 1), length, same(a**2 + p[other] ** 2, 1))
    return implies(theorem5.special(A), ends)


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

# v ↦ p·v with |p| = 1 preserves lengths and is connected to the identity, so it is in SO(4). If it
# fixes a nonzero vector, p − 1 is a divisor of 0.
FOUR = Assertion("norm(p) == 1 => norm(p - 1) == 0")
TWO_AND_THREE = (Assertion.of(THEOREM_4), theorem5.SO3_IS_COFACTORS, theorem5.FIXED_VECTOR)
EVERY_N = "for n = 2, 3 and 4, every A in SO(n) is a rotation: it fixes all vectors perpendicular to a plane"
UP_TO_3 = (
    "for n = 2 and 3, every A in SO(n) is a rotation: it fixes all vectors perpendicular to a plane"
)
REAL_SPACE = "Rotations of the real space are meant."

COMPUTED = {
    "C2.1-a": Propositions(
        as_printed=OnlyOver(
            Assertion(
                f"{ARCTG} => {POLAR}",
                words="r = √(x² + y²) and θ = arctg y/x make x = r cos θ and y = r sin θ",
            ),
            (REAL,),
            "arctg is a real function.",
            (CIRCLE,),
        ),
        spoilt=OnlyOver(
            Assertion(f"{ARCTG} => z**2*y**2 == p[0]**2"), (REAL,), "arctg is a real function."
        ),
        corrected=Angles(
            Assertion(
                ANGLE_OF_POINT,
                words="if r² = x² + y² and r ≠ 0, then x = r cos θ and y = r sin θ for the angle θ of "
                "the point (x/r, y/r) of the circle",
            )
        ),
    ),
    "C2.1.1-d": Propositions(
        as_printed=OnlyOver(Every((*TWO_AND_THREE, FOUR), EVERY_N), (REAL,), REAL_SPACE, (CIRCLE,)),
        spoilt=OnlyOver(Every(TWO_AND_THREE, UP_TO_3), (REAL,), REAL_SPACE, (CIRCLE,)),
        corrected=OnlyOver(Every(TWO_AND_THREE, UP_TO_3), (REAL,), REAL_SPACE, (CIRCLE,)),
    ),
    "C2.1.1-e": Propositions(
        as_printed=Angles(
            Assertion.of(THEOREM_4, words="every A in SO(2) is [[c, −s], [s, c]] with c² + s² = 1")
        ),
        spoilt=Angles(Assertion.of(implies(orthogonal(A), FIRST_COLUMN))),
    ),
    "C2.1.1-g": Propositions(
        as_printed=Angles(
            Assertion.of(
                angle_found(1), words="A ∈ SO(2) makes det Aᵗ = 1 and det A = a11² + a12² = 1"
            )
        ),
        spoilt=Angles(Assertion.of(angle_found(3))),
    ),
}
