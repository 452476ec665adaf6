"""Section 3.1.1: the functions that turn points by quaternions.

What a function returns is found by running it on symbols (:mod:`rotation.ledger.symbols`), and the
formula that comes back is compared with the product of ``hfield``. Arguments of type list are the
coordinates over i, j, k of the unknowns p and q; s and t stand for a cosine and a sine.
"""

from hfield.ledger.propositions import Over, Statement
from rotation.ledger.programs import claim, listed
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


CLAIMS = (
    claim(
        "C3.1.1-a",
        "quaternion-field",
        "term",
        "“ciało kwaternionów”: the real quaternions are a field",
        "ciele kwaterionów",
        Over("RR", Statement("(q != 0 => q*inv(q) == e) and p*q == q*p")),
        spoilt=Over("RR", Statement("q != 0 => q*inv(q) == e")),
        corrected=Over("RR", Statement("q != 0 => q*inv(q) == e")),
        note="A “ciało” is commutative; the quaternions are a division ring (“ciało nieprzemienne”).",
    ),
    claim(
        "C3.1.1-b",
        "helper-functions",
        "number",
        "Four helper functions are listed: dotProduct, crossProduct, scalarVector, addingVectorPart",
        "4 nowe funkcje",
        listed(HELPERS, 4),
        spoilt=listed(HELPERS, 5),
    ),
    claim(
        "C3.1.1-c",
        "threefold-slowdown",
        "number",
        "Conditional statements and loops slowed the rotation almost threefold",
        "niemal trzykrotnie",
        note="A timing of a program that the thesis does not show.",
    ),
    claim(
        "C3.1.1-d",
        "dot-product-function",
        "spec",
        "dotProduct multiplies corresponding elements and adds them",
        "lists of size 3",
        same(DOT.text, f"scalar({point(P)}*conj({point(Q)}))", words="dotProduct(p, q) = Sc(p·q̄)"),
        spoilt=same(DOT.text, f"scalar({point(P)}*{point(Q)})"),
    ),
    claim(
        "C3.1.1-e",
        "cross-product-function",
        "spec",
        "crossProduct returns the vector product, a list of size 3",
        "iloczyn wektorowy",
        same(CROSS, f"vector({point(P)}*{point(Q)})", words="crossProduct(p, q) = Vec(p·q)"),
        spoilt=same(CROSS, f"vector({point(Q)}*{point(P)})"),
    ),
    claim(
        "C3.1.1-f",
        "scalar-times-vector",
        "spec",
        "scalarVector multiplies a list of three by a number",
        "przemnożenie wektora przez stałą",
        same(point(code("scalarVector")(S, Q)), f"s*{point(Q)}", words="scalarVector(s, q) = s·q"),
        spoilt=same(point(code("scalarVector")(S, Q)), point(Q)),
    ),
    claim(
        "C3.1.1-g",
        "sum-of-vectors",
        "spec",
        "addingVectorPart adds two lists element by element",
        "dodaje",
        same(
            point(code("addingVectorPart")(P, Q)),
            f"{point(P)} + {point(Q)}",
            words="addingVectorPart(p, q) = p + q",
        ),
        spoilt=same(point(code("addingVectorPart")(P, Q)), f"{point(P)} - {point(Q)}"),
    ),
    claim(
        "C3.1.1-h",
        "product-scalar-part",
        "spec",
        "The scalar part of multiQuaternion is a1 − a2 − dotProduct(v1, v2)",
        "a1 − a2 − dotProduct(v1, v2)",
        same(PRINTED_SCALAR.text, "scalar(p*q)"),
        spoilt=same(PRODUCT[0].text, "scalar(p*q)"),
        corrected=same(PRODUCT[0].text, "scalar(p*q)"),
        note="The first minus is a product: a1·a2 − dotProduct(v1, v2).",
    ),
    claim(
        "C3.1.1-i",
        "product-vector-part",
        "spec",
        "The vector part is crossProduct(v1, v2) + scalarVector(a1, v2) + scalarVector(a2, v1)",
        "(as stated)",
        same(
            point(PRODUCT[1]),
            "vector(p*q)",
            words="multiQuaternion(a1, v1, a2, v2)[1] = Vec(q1·q2)",
        ),
        spoilt=same(point(PRODUCT[1]), "vector(q*p)"),
    ),
    claim(
        "C3.1.1-j",
        "conjugate-function",
        "spec",
        "conjugateQuaternion keeps the scalar and changes the signs of the list",
        "zmiana znaków",
        same(quaternion(*CONJUGATE), "conj(p)", words="conjugateQuaternion(a, v) = q̄"),
        spoilt=same(quaternion(*CONJUGATE), "-conj(p)"),
    ),
    claim(
        "C3.1.1-k",
        "angle-of-rotation",
        "spec",
        "The angle of rotationquaternion is the angle of the rotation",
        "angle … kąt obrotu",
        same(
            TURNED,
            rodrigues("s**2 - t**2", "2*s*t"),
            CIRCLE,
            UNIT,
            words="rotationquaternion(angle, u, x) = cos(angle)·x + sin(angle)·u×x "
            "+ (1 − cos(angle))·(u∘x)·u if |u| = 1",
        ),
        spoilt=same(WITHOUT_HALVING, rodrigues("s", "t"), CIRCLE, UNIT),
        note="With s, t the cosine and sine of half the angle in the quaternion, which the text does "
        "not say: with those of the angle itself it would turn by twice the angle (the twin).",
    ),
    claim(
        "C3.1.1-l",
        "inverse-by-conjugate",
        "spec",
        "The inverse is computed with conjugateQuaternion",
        "kwaternion odwrotny … conjugateQuaternion()",
        same(
            f"p*{quaternion(*CONJUGATE)}",
            "e",
            "norm(p) == 1",
            words="q·conjugateQuaternion(q) = e if |q| = 1",
        ),
        spoilt=same(f"p*{quaternion(*CONJUGATE)}", "e"),
        note="For a quaternion of modulus 1, which an axis of length 1 gives; the text asks for one.",
    ),
    claim(
        "C3.1.1-m",
        "axis-of-length-1",
        "claim",
        "rotation_axis must have length 1",
        "długości równej 1",
        axis_stays("t != 0", words=LENGTH_1),
        spoilt=axis_stays(),
        note="The axis stays where it is exactly when its length is 1. For a rotation by a multiple of "
        "2π (t = 0, the twin) every axis serves. The text calls the axis a quaternion.",
    ),
    claim(
        "C3.1.1-n",
        "normalise",
        "spec",
        "NormalizeVector divides each element by the Euclidean norm",
        "norma euklidesowa",
        Statement(
            NORMALISED,
            (LENGTH, "y != 0"),
            "if v ≠ 0, NormalizeVector(v)·|v| = v and NormalizeVector(v) has length 1",
        ),
        spoilt=Statement(NORMALISED, (LENGTH,)),
        note="y is the norm. Read for the axis of a rotation, which is not 0: that has no direction.",
    ),
    claim(
        "C3.1.1-o",
        "cost-of-normalising",
        "claim",
        "Normalisation does not affect the time much",
        "nie wpływa w dużym stopniu",
        note="A timing, and a matter of judgement; `hfield bench` measures it.",
    ),
    claim(
        "C3.1.1-p",
        "conjugation",
        "spec",
        "The rotation multiplies q·element·q⁻¹ and returns the vector part",
        "odpowiedni … mnożenia",
        same(
            CONJUGATED,
            f"p*{point(Q)}*inv(p)",
            "norm(p) == 1",
            words="rotationquaternionChaged(a, v, x) = q·x·q⁻¹ if |q| = 1",
        ),
        spoilt=same(CONJUGATED, f"inv(p)*{point(Q)}*p", "norm(p) == 1"),
        note="Read in the order of qvq⁻¹, as at the start of the section.",
    ),
)
