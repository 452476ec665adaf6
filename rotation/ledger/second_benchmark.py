"""The functions of the second test of 3.2, evaluated on symbolic points.

The test rotates every point about its own direction, and by the Euler angles given by its coordinates.
"""

from hfield.ledger.propositions import Assertion
from hfield.syntax import Node, both, comm, names, negation, norm, number, unequal
from hfield.syntax import equal as same
from rotation.ledger.symbolic_runs import code, coordinates, equal, point, read_as

P, Q = coordinates("p"), coordinates("q")
S, T, X, Y, ANGLE = names("s t x y angle")
PLACE = point(P)
LENGTH = same(Y**2, norm(PLACE))
CIRCLE = same(S**2 + T**2, 1)
HALF = {"cos": read_as({"0.5*angle": "s"}), "sin": read_as({"0.5*angle": "t"})}

SELF = "rotationquaternion(angle, x/|x|, x)"

# The point p turned about itself, normalised: y is its length, t the sine of half the angle.
NORM = {"sqrt": lambda square: Y}
ITSELF = point(code("rotationquaternionNormalized", **HALF, **NORM)(ANGLE, P, P))
STAYS = Assertion.of(same(ITSELF, PLACE), (LENGTH, unequal(Y, 0), CIRCLE), f"{SELF} = x")
MOVES = Assertion.of(
    unequal(ITSELF, PLACE), (LENGTH, unequal(Y, 0), CIRCLE, unequal(T, 0)), f"{SELF} ≠ x"
)

# With one axis for every point: q, of length 1.
OWN = point(code("rotationquaternion", **HALF)(ANGLE, Q, P))
UNIT = same(norm(point(Q)), 1)
STAYS_ABOUT_ANOTHER = Assertion.of(same(OWN, PLACE), (UNIT, CIRCLE))
MOVES_ABOUT_ANOTHER = Assertion.of(
    unequal(OWN, PLACE),
    (UNIT, CIRCLE, unequal(T * comm(PLACE, point(Q)), 0)),
    "if u has length 1 and is not parallel to x, and sin(angle/2) ≠ 0, "
    "rotationquaternion(angle, u, x) ≠ x",
)

# The Euler angle (a, 0, 0) of the point (a, 0, 0), with s, t the cosine and sine of a.
ANGLES = {
    "cos": read_as({"x": "s", "zero": "1"}),
    "sin": read_as({"x": "t", "zero": "0"}),
}


def euler_turned(angle: str) -> Assertion:
    """Return the claim that the matrix model moves the point (x, 0, 0) if the sine of x is not 0."""
    matrix = code("rotationMatrixZYX", **ANGLES)(*names(f"{angle} zero zero"))
    place = [X, number(0), number(0)]
    turned = code("rotationbyMatrix")(matrix, place)
    words = (
        f"if sin x ≠ 0, rotationbyMatrix(rotationMatrixZYX({angle}, 0, 0), [x, 0, 0]) ≠ [x, 0, 0]"
    )
    return Assertion.of(
        negation(equal(turned, place)), (CIRCLE, unequal(T, 0), unequal(X, 0)), words
    )


# Two triples of Euler angles: cosines and sines in p, q, r (about z, y, x) and in u, v, w.
FIRST, SECOND = ("p", "q", "r"), ("u", "v", "w")


def euler_matrix(unknowns: tuple[str, str, str]) -> list[list[Node]]:
    """Return the matrix for three angles; their cosines and sines are coordinates 0 and 1 of the unknowns."""
    read = {
        "cos": read_as({a: f"{a}[0]" for a in unknowns}),
        "sin": read_as({a: f"{a}[1]" for a in unknowns}),
    }
    matrix: list[list[Node]] = code("rotationMatrixZYX", **read)(*names(" ".join(unknowns)))
    return matrix


def determined(*cosines: str) -> Assertion:
    """Return the claim that equal matrices have equal angles, if the cosines of the middle angles satisfy a
    condition.

    The last row and the first column of the matrices determine the angles.
    """
    circles = [f"{a}[0]**2 + {a}[1]**2 == 1" for a in (FIRST[1], SECOND[1])]
    angle_entries = [
        [m[2][0], m[2][1], m[2][2], m[0][0], m[1][0]] for m in map(euler_matrix, (FIRST, SECOND))
    ]
    pairs = zip(names("p q r"), names("u v w"), strict=True)
    alike = both(*(same(a[n], b[n]) for a, b in pairs for n in (0, 1)))
    words = (
        "if rotationMatrixZYX(x) = rotationMatrixZYX(y) and the middle cosines are positive, x = y"
    )
    return Assertion.of(alike, (*circles, equal(*angle_entries), *cosines), words)
