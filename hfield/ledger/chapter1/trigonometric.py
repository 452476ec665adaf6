"""Section 1.4.4: the trigonometric form.

An angle θ is met through the point (cos θ, sin θ) of the unit circle alone; what only speaks of
such points has an algebraic core over every field. In the formulas s, y and z stand for |q|, ‖q⃗‖,
cos θ or sin θ as the claim needs them, since x and t name variables of some fields.
"""

from hfield.ledger.document import Propositions
from hfield.ledger.propositions import Statement
from hfield.ledger.scopes import Only

CIRCLE = "(cos θ, sin θ) runs once through the points of the circle c² + s² = 1 for θ in [0, 2π)"
REAL = "Angles are real numbers."


def real(formula: str) -> Only:
    """Return a statement about angles: it means something over RR only."""
    return Only(Statement(formula), ("RR",), REAL, (CIRCLE,))


# q0 = y and ‖q⃗‖ = z; the angle sought is that of (y, z) or of (−y, z), whichever is not (1, 0).
SQUARES = (
    "y**2 + z**2 == 1 => "
    "(y != 1 and y**2 + z**2 == 1) or (-y != 1 and (-y)**2 + z**2 == 1 and (-y)**2 == y**2)"
)
# (s, t) = (cos θ, sin θ) with θ in (0, 2π), so that it is not (1, 0).
ROOTS = (
    "s**2 + t**2 == 1 and s != 1 and y**2 + z**2 == 1 and y**2 == s**2 and z**2 == t**2"
    " => y == s and z == t"
)

COMPUTED = {
    "C1.4.4-b": Propositions(
        as_printed=real(SQUARES), spoilt=real("y**2 + z**2 == 1 => y != 1 and y**2 + z**2 == 1")
    ),
    "C1.4.4-c": Propositions(
        as_printed=real(ROOTS),
        spoilt=real("s**2 + t**2 == 1 and y == s and z == t => y**2 + z**2 == 1"),
        corrected=real("s**2 + t**2 == 1 and y == s and z == t => y**2 + z**2 == 1"),
    ),
}
