"""Section 3.4.2: one quaternion for two rotations, and Theorem 7.

p and q are q₁ and q₂ of the thesis, and v is the point. The functions of :mod:`rotation.thesis` are run on
terms to find their results.
"""

from collections.abc import Callable
from dataclasses import replace

from anim.ledger.counting import RING, takes
from hfield.ledger.claim import Computed, ComputedResult
from hfield.ledger.document import Propositions
from hfield.ledger.propositions import Assertion
from hfield.syntax import Node, both, conj, equal, inv, names, norm, unequal
from rotation.ledger.symbolic_runs import Vector, code, coordinates, point, quaternion, scalar

BOTH = ("norm(p) != 0", "norm(q) != 0")
FORMULA = "p*q*v*inv(q)*inv(p)"

P, Q, E, Y, Z, K = names("p q e y z k")
ELEMENT = coordinates("v")
# A quaternion that turns about the z axis, and a point.
SPIN, POINT = Y + Z * K, point(ELEMENT)
AS_PRINTED = SPIN * Q * POINT * inv(Q) * inv(SPIN)
EXCHANGED = Q * SPIN * POINT * inv(SPIN) * inv(Q)

THEOREM_7 = "inv(p*q) == inv(q)*inv(p)"


def proof(conjugates: Node) -> Node:
    """Return each step of the proof of Theorem 7, given the term for the conjugate of the product."""
    whole, parts = conj(P * Q) / norm(P * Q), conjugates / (norm(Q) * norm(P))
    return both(equal(inv(P * Q), whole), equal(whole, parts), equal(parts, inv(Q) * inv(P)))


Parts = tuple[Node, Vector]
Q1, Q2 = ((scalar(name), coordinates(name)) for name in "pq")
TWICE = code("rotationquaternionChaged")(
    *Q2, code("rotationquaternionChaged")(*Q1, ELEMENT)
)  # first about z


def first_about_z(turned: Node, name: str) -> Assertion:
    """Return the claim that a term is the point rotated about the z axis, then by q; ``name`` describes the
    term.
    """
    spun = SPIN * POINT * inv(SPIN)
    return Assertion.of(
        equal(turned, Q * spun * inv(Q)),
        (unequal(norm(SPIN), 0), unequal(norm(Q), 0)),
        f"{name} is x turned first about the z axis, by q1, and then by q2",
    )


def once(first: Parts, second: Parts, name: str) -> Assertion:
    """Return the claim that two rotations equal one by the product; ``name`` describes the product."""
    product = code("multiQuaternion")(*second, *first)
    turned = code("rotationquaternionChaged")(*product, ELEMENT)
    return Assertion.of(
        equal(point(TWICE), point(turned)),
        words=f"turning by q1 and then by q2 is rotationquaternionChaged({name}, x)",
    )


PRODUCT = code("multiQuaternion")(*Q1, *Q2)
INVERSE = Assertion.of(
    equal(quaternion(*PRODUCT) * quaternion(*code("conjugateQuaternion")(*PRODUCT)), E),
    ("norm(p) == 1", "norm(q) == 1"),
    "if |q1| = |q2| = 1, conjugateQuaternion of the product is its inverse",
)


class MultiplicationCounter:
    """A scalar without a value that counts multiplications."""

    def __init__(self) -> None:
        self.count = 0

    def __mul__(self, other: object) -> "MultiplicationCounter":
        self.count += 1
        return self

    def _other(self, *other: object) -> "MultiplicationCounter":
        return self

    __rmul__ = __mul__
    __add__ = __radd__ = __sub__ = __rsub__ = __neg__ = _other


def work(points: int) -> tuple[int, int]:
    """Return the numbers of multiplications that spin3d and spin3dOptimized need for so many points.

    Per frame, spin3d needs two rotations for each point; spin3dOptimized needs one for each point, and the
    product of the two quaternions once.
    """
    read: dict[str, Callable[[Node], Node]] = {"cos": lambda x: x, "sin": lambda x: x}
    t = MultiplicationCounter()
    v = [t, t, t]
    code("rotationquaternion", **read)(t, v, code("rotationquaternion", **read)(t, v, v))
    twice, t.count = t.count, 0
    code("rotationquaternionChaged")(t, v, v)
    single, t.count = t.count, 0
    halves = [code("scalarVector")(0.5 * t, v) for _ in range(2)]  # cos, and sin times the axis
    code("multiQuaternion")(t, halves[0], t, halves[1])
    return twice * points, single * points + t.count


def saves(factor: int) -> Computed:
    """Return the claim that spin3dOptimized needs fewer multiplications for the model by this factor."""

    def check_claim() -> ComputedResult:
        from anim.model import Model

        points = len(Model(ring=RING).points)
        before, after = work(points)
        steps = (
            f"{points} points: {2 * points} rotations, {before} multiplications by spin3d",
            f"{points} rotations, {after} multiplications by spin3dOptimized",
        )
        return ComputedResult(before >= factor * after, steps, {"multiplications": [str(after)]})

    return Computed(
        f"spin3dOptimized takes {factor} times fewer multiplications than spin3d", check_claim
    )


COMPUTED = {
    "C3.4.2-a": Propositions(
        as_printed=first_about_z(AS_PRINTED, "q1·q2·x·q2⁻¹·q1⁻¹"),
        spoilt=first_about_z(EXCHANGED, "q2·q1·x·q1⁻¹·q2⁻¹"),
        corrected=first_about_z(EXCHANGED, "q2·q1·x·q1⁻¹·q2⁻¹"),
    ),
    "C3.4.2-b": Propositions(
        as_printed=Assertion(f"{FORMULA} == (p*q)*v*inv(p*q)", BOTH),
        spoilt=Assertion(f"{FORMULA} == (q*p)*v*inv(q*p)", BOTH),
    ),
    "C3.4.2-c": Propositions(as_printed=Assertion(THEOREM_7, BOTH), spoilt=Assertion(THEOREM_7)),
    "C3.4.2-d": Propositions(
        as_printed=Assertion.of(proof(conj(Q) * conj(P)), BOTH),
        spoilt=Assertion.of(proof(conj(P) * conj(Q)), BOTH),
    ),
    "C3.4.2-e": Propositions(as_printed=once(Q1, Q2, "q2·q1"), spoilt=once(Q2, Q1, "q1·q2")),
    "C3.4.2-f": Propositions(
        as_printed=takes("rotationquaternionChaged", 4),
        spoilt=takes("rotationquaternionChaged", 3),
        corrected=takes("rotationquaternionChaged", 3),
    ),
    "C3.4.2-g": Propositions(
        as_printed=INVERSE, spoilt=replace(INVERSE, given=("norm(p) == 1",), words="")
    ),
    "C3.4.2-h": Propositions(as_printed=saves(2), spoilt=saves(3)),
}
