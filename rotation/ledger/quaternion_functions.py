"""Section 3.1.1: the functions that rotate points by quaternions.

A function is run on terms (:mod:`rotation.ledger.symbolic_runs`), and the resulting formula is compared with
the product of ``hfield``. Arguments of type list are the coordinates over i, j, k of the unknowns p and q; s
and t stand for a cosine and a sine.
"""

from hfield.ledger.document import Propositions
from hfield.ledger.propositions import Assertion
from hfield.ledger.scopes import InField
from hfield.syntax import Node, both, conj, equal, iff, inv, names, norm, scalar, unequal, vector
from rotation.ledger.listed_functions import listed
from rotation.ledger.symbolic_runs import code, coordinates, point, quaternion, read_as
from rotation.ledger.symbolic_runs import scalar as real_part

P, Q = coordinates("p"), coordinates("q")
A, B = real_part("p"), real_part("q")
S, T, Y, ANGLE = names("s t y angle")
ANY, OTHER, E = names("p q e")
U, V = point(P), point(Q)
CIRCLE = equal(S**2 + T**2, 1)
UNIT = equal(norm(U), 1)

# The functions named in the thesis, in its order.
HELPERS = ("dotProduct", "crossProduct", "scalarVector", "addingVectorPart")

PRODUCT = code("multiQuaternion")(A, P, B, Q)
CONJUGATE = code("conjugateQuaternion")(A, P)
DOT = code("dotProduct")(P, Q)
CROSS = point(code("crossProduct")(P, Q))
PRINTED_SCALAR = A - B - DOT

# The functions with the half angle: cos(angle/2) = s, sin(angle/2) = t.
HALF = {"cos": read_as({"0.5*angle": "s"}), "sin": read_as({"0.5*angle": "t"})}
TURNED = point(code("rotationquaternion", **HALF)(ANGLE, P, Q))
AXIS_TURNED = point(code("rotationquaternion", **HALF)(ANGLE, P, P))
WITHOUT_HALVING = point(code("rotationquaternionChaged")(S, code("scalarVector")(T, P), Q))
CONJUGATED = point(code("rotationquaternionChaged")(A, P, Q))

UNIT_VECTOR = point(code("NormalizeVector", sqrt=lambda square: Y)(P))
NORMALISED = both(equal(UNIT_VECTOR * Y, U), equal(norm(UNIT_VECTOR), 1))
LENGTH_1 = "if sin(angle/2) ≠ 0 and u ≠ 0, rotationquaternion(angle, u, u) = u exactly when |u| = 1"
LENGTH = equal(Y**2, norm(U))


def axis_stays(*given: Node, words: str = "") -> Assertion:
    """Return the claim that the nonzero axis p is fixed if and only if its length is 1."""
    stays = equal(AXIS_TURNED, U)
    return Assertion.of(iff(stays, UNIT), (CIRCLE, unequal(U, 0), *given), words)


def rodrigues(cosine: Node, sine: Node) -> Node:
    """Return the point q rotated about the unit vector p by the angle with this cosine and sine."""
    return cosine * V + sine * vector(U * V) - (1 - cosine) * scalar(U * V) * U


def same(left: Node, right: Node, *given: Node, words: str = "") -> Assertion:
    """Return an equality under hypotheses."""
    return Assertion.of(equal(left, right), given, words)


COMPUTED = {
    "C3.1.1-a": Propositions(
        as_printed=InField("RR", Assertion("(q != 0 => q*inv(q) == e) and p*q == q*p")),
        spoilt=InField("RR", Assertion("q != 0 => q*inv(q) == e")),
        corrected=InField("RR", Assertion("q != 0 => q*inv(q) == e")),
    ),
    "C3.1.1-b": Propositions(as_printed=listed(HELPERS, 4), spoilt=listed(HELPERS, 5)),
    "C3.1.1-d": Propositions(
        as_printed=same(DOT, scalar(U * conj(V)), words="dotProduct(p, q) = Sc(p·q̄)"),
        spoilt=same(DOT, scalar(U * V)),
    ),
    "C3.1.1-e": Propositions(
        as_printed=same(CROSS, vector(U * V), words="crossProduct(p, q) = Vec(p·q)"),
        spoilt=same(CROSS, vector(V * U)),
    ),
    "C3.1.1-f": Propositions(
        as_printed=same(point(code("scalarVector")(S, Q)), S * V, words="scalarVector(s, q) = s·q"),
        spoilt=same(point(code("scalarVector")(S, Q)), V),
    ),
    "C3.1.1-g": Propositions(
        as_printed=same(
            point(code("addingVectorPart")(P, Q)),
            U + V,
            words="addingVectorPart(p, q) = p + q",
        ),
        spoilt=same(point(code("addingVectorPart")(P, Q)), U - V),
    ),
    "C3.1.1-h": Propositions(
        as_printed=same(PRINTED_SCALAR, scalar(ANY * OTHER)),
        spoilt=same(PRODUCT[0], scalar(ANY * OTHER)),
        corrected=same(PRODUCT[0], scalar(ANY * OTHER)),
    ),
    "C3.1.1-i": Propositions(
        as_printed=same(
            point(PRODUCT[1]),
            vector(ANY * OTHER),
            words="multiQuaternion(a1, v1, a2, v2)[1] = Vec(q1·q2)",
        ),
        spoilt=same(point(PRODUCT[1]), vector(OTHER * ANY)),
    ),
    "C3.1.1-j": Propositions(
        as_printed=same(quaternion(*CONJUGATE), conj(ANY), words="conjugateQuaternion(a, v) = q̄"),
        spoilt=same(quaternion(*CONJUGATE), -conj(ANY)),
    ),
    "C3.1.1-k": Propositions(
        as_printed=same(
            TURNED,
            rodrigues(S**2 - T**2, 2 * S * T),
            CIRCLE,
            UNIT,
            words="rotationquaternion(angle, u, x) = cos(angle)·x + sin(angle)·u×x "
            "+ (1 − cos(angle))·(u∘x)·u if |u| = 1",
        ),
        spoilt=same(WITHOUT_HALVING, rodrigues(S, T), CIRCLE, UNIT),
    ),
    "C3.1.1-l": Propositions(
        as_printed=same(
            ANY * quaternion(*CONJUGATE),
            E,
            equal(norm(ANY), 1),
            words="q·conjugateQuaternion(q) = e if |q| = 1",
        ),
        spoilt=same(ANY * quaternion(*CONJUGATE), E),
    ),
    "C3.1.1-m": Propositions(
        as_printed=axis_stays(unequal(T, 0), words=LENGTH_1), spoilt=axis_stays()
    ),
    "C3.1.1-n": Propositions(
        as_printed=Assertion.of(
            NORMALISED,
            (LENGTH, unequal(Y, 0)),
            "if v ≠ 0, NormalizeVector(v)·|v| = v and NormalizeVector(v) has length 1",
        ),
        spoilt=Assertion.of(NORMALISED, (LENGTH,)),
    ),
    "C3.1.1-p": Propositions(
        as_printed=same(
            CONJUGATED,
            ANY * V * inv(ANY),
            equal(norm(ANY), 1),
            words="rotationquaternionChaged(a, v, x) = q·x·q⁻¹ if |q| = 1",
        ),
        spoilt=same(CONJUGATED, inv(ANY) * V * ANY, equal(norm(ANY), 1)),
    ),
}
