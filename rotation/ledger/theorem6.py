"""Section 2.2.5: unit and pure quaternions, and Theorem 6 on the rotation T_q.

c = cos θ and s = sin θ are the scalars ``y`` and ``s``; the axis u and the point v are the vector parts
``vector(u)`` and ``vector(v)``. So everything holds over every commutative ring: in ℤ[c, s, u₁, u₂, u₃]/(c² +
s² − 1, u∘u − 1), and in every ring to which this ring maps.
"""

from hfield.ledger.document import Propositions
from hfield.ledger.propositions import Assertion
from hfield.ledger.real_geometry import Angles
from hfield.syntax import Node, both, equal, implies, names, norm, vector
from rotation.ledger.entries import coordinates, cross, dot
from rotation.ledger.plane import ON_CIRCLE
from rotation.ledger.symbolic_runs import point

A, B = coordinates("u"), coordinates("v")
C, S, AXIS, PLACE = names("y s u v")
U, V, W = vector(AXIS), vector(PLACE), point(cross(A, B))
Q, BAR = C + S * U, C - S * U
COS, SIN = C**2 - S**2, 2 * C * S  # of 2θ


def theorem_6(along: Node) -> Node:
    """Return the claim that Q is Rodrigues' formula; ``along`` is its last term, where 1 − cos 2θ is 2s²."""
    turned = COS * V + SIN * W + along
    ends = equal(Q * V * BAR, turned), equal(Q * BAR, 1), equal(BAR * Q, 1)
    return implies(both(ON_CIRCLE, equal(norm(U), 1)), both(*ends))


ALONG = 2 * S**2 * dot(A, B) * U


COMPUTED = {
    "C2.2.5-e": Propositions(
        as_printed=Angles(
            Assertion.of(
                theorem_6(ALONG),
                words="if c² + s² = 1 and |u| = 1, then (c + su)v(c − su) = (c² − s²)v + 2cs(u×v) + "
                "2s²(u∘v)u, and c − su is the inverse of c + su",
            )
        ),
        spoilt=Angles(Assertion.of(theorem_6(-ALONG))),
    ),
}
