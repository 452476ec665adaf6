"""Euler angles (end of 2.2.3) and the matrix R_z(φ)R_y(θ)R_x(ψ) of section 2.2.4.

The angles φ, θ, ψ are the points (p₀, p₁), (p₂, p₃), (q₀, q₁) of the circle, and v is a point of space.
"""

from hfield.checker.glossary import CIRCLE
from hfield.ledger.claim import Proposition
from hfield.ledger.document import Propositions
from hfield.ledger.modulus import ModulusDefined
from hfield.ledger.propositions import Assertion, Every
from hfield.ledger.real_geometry import REAL, Angles
from hfield.ledger.scopes import OnlyOver
from hfield.syntax import Node, both, implies, names, parse
from hfield.syntax import equal as same
from rotation.ledger.entries import (
    ZERO,
    det,
    equal,
    matrix,
    orthogonal,
    times,
    transpose,
)
from rotation.ledger.space import about_x, about_y, about_z
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

PRINTED_ZYX = matrix(
    "p[0]*p[2], p[0]*p[3]*q[1] - p[1]*q[0], p[0]*p[3]*q[0] + p[1]*q[1];"
    "p[1]*p[2], p[1]*p[3]*q[1] + p[0]*q[0], p[1]*p[3]*q[0] - p[0]*q[1];"
    "-p[3], p[2]*q[1], p[2]*q[0]"
)

P, Q, R, Y, Z = names("p q r y z")

# For R in SO(3) let cos θ = z, where z² = r11² + r21², and y = 1/z. If z ≠ 0, all three angles can
# be read off the first column and the last row; if r11 = r21 = 0, φ = 0 is a possible choice.
FIRST, LAST = "p[1]**2 + q[1]**2 == z**2", "r[2]**2 + r[3]**2 == z**2"
TIMES_SQUARE = {  # the other four entries of R, times z²
    (0, 1): "-p[1]*r[1]*r[2] - q[1]*r[3]",
    (0, 2): "q[1]*r[2] - p[1]*r[1]*r[3]",
    (1, 1): "p[1]*r[3] - q[1]*r[1]*r[2]",
    (1, 2): "-p[1]*r[2] - q[1]*r[1]*r[3]",
}
FOUR = {(r, c): same(Z**2 * ANY[r][c], parse(text)) for (r, c), text in TIMES_SQUARE.items()}
ENTRIES = implies(
    both(ORTHOGONAL, orthogonal(transpose(ANY)), OWN_COFACTORS, FIRST),
    both(LAST, "z**2 + r[1]**2 == 1", *FOUR.values()),
)
FROM_ENTRIES = times(about_z(P[1] * Y, Q[1] * Y), about_y(Z, -R[1]), about_x(R[3] * Y, R[2] * Y))
SAME = {(r, c): same(ANY[r][c], FROM_ENTRIES[r][c]) for r in range(3) for c in range(3)}
INVERSE = same(Y * Z, 1)
GENERAL = (
    *(implies(both(INVERSE, FOUR[at]), SAME[at]) for at in FOUR),
    implies(INVERSE, both(*(entry for at, entry in SAME.items() if at not in FOUR))),
    implies(both(INVERSE, FIRST), "(p[1]*y)**2 + (q[1]*y)**2 == 1"),
    implies(both(INVERSE, LAST), "(r[3]*y)**2 + (r[2]*y)**2 == 1"),
)


def locked(sine: Node) -> Node:
    """Return the claim what R is if r11 = r21 = 0, given the sine of the angle about x."""
    left = both(ORTHOGONAL, OWN_COFACTORS, "p[1] == 0", "q[1] == 0")
    turned = equal(ANY, times(about_y(ZERO, -R[1]), about_x(Q[2], sine)))
    return implies(left, both(turned, "r[1]**2 == 1", "q[2]**2 + q[3]**2 == 1"))


REAL_ANGLES = "Angles of rotations of the real space are meant."


def every_rotation(sine: Node) -> OnlyOver:
    """Return the claim that every rotation has Euler angles; ``sine`` belongs to x where r11 = r21 = 0."""
    parts: tuple[Proposition, ...] = (
        SO3_IS_COFACTORS,
        SO3_COLUMNS,
        ModulusDefined(),
        Assertion.of(ENTRIES, words="the first column and the last row give the rest, times z²"),
        *map(Assertion.of, GENERAL),
        Assertion("p[1]**2 + q[1]**2 == 0 => p[1] == 0 and q[1] == 0"),
        Assertion.of(locked(sine), words="where r11 = r21 = 0, R is R_y(θ)R_x(γ)"),
    )
    words = "every R in SO(3) is R_z(ψ)R_y(θ)R_x(γ) for some angles ψ, θ, γ"
    return OnlyOver(Every(parts, words), (REAL,), REAL_ANGLES, (CIRCLE,))


PRODUCT_IS_I = Assertion.of(implies(ANGLES, orthogonal(PRINTED_ZYX)), words="R_zyx·R_zyxᵗ = I")

COMPUTED = {
    "C2.2.3-e": Propositions(as_printed=every_rotation(-Q[3]), spoilt=every_rotation(Q[3])),
    "C2.2.4-j": Propositions(
        as_printed=Angles(
            Every(
                (
                    PRODUCT_IS_I,
                    Assertion.of(implies(ANGLES, same(det(PRINTED_ZYX), 1)), words="det R_zyx = 1"),
                    CORE,
                ),
                f"R_zyx is in SO(3), and {CORE.text}",
            ),
            REAL_PART,
        ),
        spoilt=Angles(Assertion.of(implies(ANGLES, equal(PRINTED_ZYX, transpose(PRINTED_ZYX))))),
    ),
}
