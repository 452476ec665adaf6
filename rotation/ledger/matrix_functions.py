"""Section 3.1.2: the functions that rotate points by matrices.

As in 3.1.1 they are run on terms; s and t stand for the cosine and the sine of half an angle.
"""

from hfield.ledger.document import Propositions
from hfield.ledger.propositions import Assertion, Every
from hfield.syntax import Name, conj, names, scalar
from hfield.syntax import equal as same
from rotation.ledger.listed_functions import listed
from rotation.ledger.symbolic_runs import code, coordinates, equal, point, read_as

Q = coordinates("q")
S, T, ANGLE, PSI, PHI, THETA = names("s t angle psi phi theta")
MATRICES = (
    "xaxisMatrixrotation",
    "yaxisMatrixrotation",
    "zaxisMatrixrotation",
    "rotationMatrixZYX",
    "rotationbyMatrix",
)


def about(axis: str, name: str) -> Assertion:
    """Return the claim that a matrix function rotates q as the quaternion of half the angle does."""
    double = {"cos": read_as({"angle": "s**2 - t**2"}), "sin": read_as({"angle": "2*s*t"})}
    matrix = code(name, **double)(ANGLE)
    turned = point(code("rotationbyMatrix")(matrix, Q))
    half = S + T * Name(axis)
    words = f"{name}(angle)·x = h·x·h̄ for h = cos(angle/2) + sin(angle/2)·{axis}"
    return Assertion.of(same(turned, half * point(Q) * conj(half)), ("s**2 + t**2 == 1",), words)


def axes(*basis: str) -> Every:
    """Return this claim for the three matrix functions, about these basis vectors."""
    return Every(tuple(map(about, basis, MATRICES)))


# (cos ψ, sin ψ) = (p0, p1), (cos φ, sin φ) = (q0, q1), (cos θ, sin θ) = (r0, r1), and the point is
# v.
EULER = {
    "cos": read_as({"psi": "p[0]", "phi": "q[0]", "theta": "r[0]"}),
    "sin": read_as({"psi": "p[1]", "phi": "q[1]", "theta": "r[1]"}),
}


def euler(order: tuple[str, str, str]) -> Assertion:
    """Return the claim that rotationMatrixZYX rotates about these axes, the last one first, by ψ, φ, θ."""
    angles = {"z": PSI, "y": PHI, "x": THETA}
    turn, v = code("rotationbyMatrix"), coordinates("v")
    matrix = code("rotationMatrixZYX", **EULER)(*angles.values())
    step = v
    for axis in reversed(order):
        step = turn(code(f"{axis}axisMatrixrotation", **EULER)(angles[axis]), step)
    words = (
        f"rotationMatrixZYX(ψ, φ, θ) turns about {order[2]}, then about {order[1]} and {order[0]}"
    )
    return Assertion.of(equal(turn(matrix, v), step), words=words)


# A matrix of arbitrary entries: its rows are the coordinates of p, q and r.
ROWS = [coordinates(row) for row in "pqr"]


def rows_times(order: tuple[int, int, int]) -> Assertion:
    """Return the claim that rotationbyMatrix returns the products of these rows with the point v."""
    v = coordinates("v")
    product = [scalar(point(ROWS[n]) * conj(point(v))) for n in order]
    words = f"rotationbyMatrix(M, x) is the product of rows {order} of M with x"
    return Assertion.of(equal(code("rotationbyMatrix")(ROWS, v), product), words=words)


COMPUTED = {
    "C3.1.2-a": Propositions(as_printed=listed(MATRICES, 5), spoilt=listed(MATRICES, 4)),
    "C3.1.2-b": Propositions(as_printed=axes("i", "j", "k"), spoilt=axes("i", "j", "i")),
    "C3.1.2-c": Propositions(as_printed=euler(("z", "y", "x")), spoilt=euler(("x", "y", "z"))),
    "C3.1.2-d": Propositions(as_printed=rows_times((0, 1, 2)), spoilt=rows_times((0, 2, 1))),
}
