"""Section 3.1.1: the functions that turn points by quaternions.

What a function returns is found by running it on symbols (:mod:`rotation.ledger.symbols`), and the
formula that comes back is compared with the product of ``hfield``. Arguments of type list are the
coordinates over i, j, k of the unknowns p and q; s and t stand for a cosine and a sine.
"""

from hfield.ledger.document import Propositions
from hfield.ledger.propositions import Over, Statement
from rotation.ledger.programs import listed
from rotation.ledger.symbols import Symbol, code, coordinates, point, quaternion, read_as, scalar

P, Q = coordinates("p"), coordinates("q")
A, B = scalar("p"), scalar("q")
S, T, Y = Symbol("s"), Symbol("t"), Symbol("y")
CIRCLE = "s**2 + t**2 == 1"
UNIT = f"norm({point(P)}) == 1"

# The functions named in the thesis, in its order.
HELPERS = ("dotProduct", "crossProduct", "scalarVector", "addingVectorPart")

PRODUCT = code("multiQuaternion")(A, P, B, Q)
CONJUGATE = code("conjugateQuaternion")(A, P)
DOT = code("dotProduct")(P, Q)
CROSS = point(code("crossProduct")(P, Q))
PRINTED_SCALAR = A - B - DOT

# The functions with the half angle: cos(angle/2) = s, sin(angle/2) = t.
HALF = {"cos": read_as({"0.5*angle": "s"}), "sin": read_as({"0.5*angle": "t"})}
TURNED = point(code("rotationquaternion", **HALF)(Symbol("angle"), P, Q))
AXIS_TURNED = point(code("rotationquaternion", **HALF)(Symbol("angle"), P, P))
WITHOUT_HALVING = point(code("rotationquaternionChaged")(S, code("scalarVector")(T, P), Q))
CONJUGATED = point(code("rotationquaternionChaged")(A, P, Q))

UNIT_VECTOR = point(code("NormalizeVector", sqrt=lambda square: Y)(P))
NORMALISED = f"{UNIT_VECTOR}*y == {point(P)} and norm({UNIT_VECTOR}) == 1"
LENGTH_1 = "if sin(angle/2) ≠ 0 and u ≠ 0, rotationquaternion(angle, u, u) = u exactly when |u| = 1"
LENGTH = f"y**2 == norm({point(P)})"


def axis_stays(*given: str, words: str = "") -> Statement:
    """Say that the axis p, not 0, stays where it is exactly when its length is 1."""
    stays = f"{AXIS_TURNED} == {point(P)}"
    return Statement(f"{stays} <=> {UNIT}", (CIRCLE, f"{point(P)} != 0", *given), words)


def rodrigues(cosine: str, sine: str) -> str:
    """Return the point q turned about the unit vector p by the angle with this cosine and sine."""
    u, v = point(P), point(Q)
    return f"({cosine})*{v} + ({sine})*vector({u}*{v}) - (1 - ({cosine}))*scalar({u}*{v})*{u}"


def same(left: str, right: str, *given: str, words: str = "") -> Statement:
    """Return an equality under hypotheses."""
    return Statement(f"{left} == {right}", given, words)


COMPUTED = {
    "C3.1.1-a": Propositions(
        as_printed=Over("RR", Statement("(q != 0 => q*inv(q) == e) and p*q == q*p")),
        spoilt=Over("RR", Statement("q != 0 => q*inv(q) == e")),
        corrected=Over("RR", Statement("q != 0 => q*inv(q) == e")),
    ),
    "C3.1.1-b": Propositions(as_printed=listed(HELPERS, 4), spoilt=listed(HELPERS, 5)),
    "C3.1.1-d": Propositions(
        as_printed=same(
            DOT.text, f"scalar({point(P)}*conj({point(Q)}))", words="dotProduct(p, q) = Sc(p·q̄)"
        ),
        spoilt=same(DOT.text, f"scalar({point(P)}*{point(Q)})"),
    ),
    "C3.1.1-e": Propositions(
        as_printed=same(
            CROSS, f"vector({point(P)}*{point(Q)})", words="crossProduct(p, q) = Vec(p·q)"
        ),
        spoilt=same(CROSS, f"vector({point(Q)}*{point(P)})"),
    ),
    "C3.1.1-f": Propositions(
        as_printed=same(
            point(code("scalarVector")(S, Q)), f"s*{point(Q)}", words="scalarVector(s, q) = s·q"
        ),
        spoilt=same(point(code("scalarVector")(S, Q)), point(Q)),
    ),
    "C3.1.1-g": Propositions(
        as_printed=same(
            point(code("addingVectorPart")(P, Q)),
            f"{point(P)} + {point(Q)}",
            words="addingVectorPart(p, q) = p + q",
        ),
        spoilt=same(point(code("addingVectorPart")(P, Q)), f"{point(P)} - {point(Q)}"),
    ),
    "C3.1.1-h": Propositions(
        as_printed=same(PRINTED_SCALAR.text, "scalar(p*q)"),
        spoilt=same(PRODUCT[0].text, "scalar(p*q)"),
        corrected=same(PRODUCT[0].text, "scalar(p*q)"),
    ),
    "C3.1.1-i": Propositions(
        as_printed=same(
            point(PRODUCT[1]),
            "vector(p*q)",
            words="multiQuaternion(a1, v1, a2, v2)[1] = Vec(q1·q2)",
        ),
        spoilt=same(point(PRODUCT[1]), "vector(q*p)"),
    ),
    "C3.1.1-j": Propositions(
        as_printed=same(quaternion(*CONJUGATE), "conj(p)", words="conjugateQuaternion(a, v) = q̄"),
        spoilt=same(quaternion(*CONJUGATE), "-conj(p)"),
    ),
    "C3.1.1-k": Propositions(
        as_printed=same(
            TURNED,
            rodrigues("s**2 - t**2", "2*s*t"),
            CIRCLE,
            UNIT,
            words="rotationquaternion(angle, u, x) = cos(angle)·x + sin(angle)·u×x "
            "+ (1 − cos(angle))·(u∘x)·u if |u| = 1",
        ),
        spoilt=same(WITHOUT_HALVING, rodrigues("s", "t"), CIRCLE, UNIT),
    ),
    "C3.1.1-l": Propositions(
        as_printed=same(
            f"p*{quaternion(*CONJUGATE)}",
            "e",
            "norm(p) == 1",
            words="q·conjugateQuaternion(q) = e if |q| = 1",
        ),
        spoilt=same(f"p*{quaternion(*CONJUGATE)}", "e"),
    ),
    "C3.1.1-m": Propositions(as_printed=axis_stays("t != 0", words=LENGTH_1), spoilt=axis_stays()),
    "C3.1.1-n": Propositions(
        as_printed=Statement(
            NORMALISED,
            (LENGTH, "y != 0"),
            "if v ≠ 0, NormalizeVector(v)·|v| = v and NormalizeVector(v) has length 1",
        ),
        spoilt=Statement(NORMALISED, (LENGTH,)),
    ),
    "C3.1.1-p": Propositions(
        as_printed=same(
            CONJUGATED,
            f"p*{point(Q)}*inv(p)",
            "norm(p) == 1",
            words="rotationquaternionChaged(a, v, x) = q·x·q⁻¹ if |q| = 1",
        ),
        spoilt=same(CONJUGATED, f"inv(p)*{point(Q)}*p", "norm(p) == 1"),
    ),
}
