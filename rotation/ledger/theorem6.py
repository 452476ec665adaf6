"""Section 2.2.5: unit and pure quaternions, and Theorem 6 on the rotation T_q.

c = cos θ and s = sin θ are the scalars ``y`` and ``s``; the axis u and the point v are the vector parts
``vector(u)`` and ``vector(v)``, so that all holds over every commutative ring, in
ℤ[c, s, u₁, u₂, u₃]/(c² + s² − 1, u∘u − 1) and any ring that it maps to.
"""

from hfield.ledger.document import Propositions
from hfield.ledger.propositions import Statement
from hfield.ledger.real import Angles
from rotation.ledger.entries import Vector, coordinates, cross, dot
from rotation.ledger.plane import ON_CIRCLE


def pure(v: Vector) -> str:
    """Return the pure quaternion with these coordinates."""
    x, y, z = v
    return f"(({x})*i + ({y})*j + ({z})*k)"


A, B = coordinates("u"), coordinates("v")
U, V, W = "vector(u)", "vector(v)", pure(cross(A, B))
Q, BAR = f"(y + s*{U})", f"(y - s*{U})"
UNIT, PERPENDICULAR = f"norm({U}) == 1", f"{dot(A, B)} == 0"
COS, SIN = "(y**2 - s**2)", "(2*y*s)"  # of 2θ
# Rodrigues' formula for the angle 2θ: 1 − cos 2θ is 2s².
TURNED = f"{COS}*{V} + {SIN}*{W} + 2*s**2*({dot(A, B)})*{U}"
THEOREM_6 = (
    f"{ON_CIRCLE} and {UNIT} => {Q}*{V}*{BAR} == {TURNED} and {Q}*{BAR} == 1 and {BAR}*{Q} == 1"
)


COMPUTED = {
    "C2.2.5-e": Propositions(
        as_printed=Angles(
            Statement(
                THEOREM_6,
                words="if c² + s² = 1 and |u| = 1, then (c + su)v(c − su) = (c² − s²)v + 2cs(u×v) + "
                "2s²(u∘v)u, and c − su is the inverse of c + su",
            )
        ),
        spoilt=Angles(Statement(THEOREM_6.replace("+ 2*s**2", "- 2*s**2"))),
    ),
}
