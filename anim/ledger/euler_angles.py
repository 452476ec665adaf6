"""Section 3.4.3: the motion by matrices, with Euler angles instead of the second rotation."""

from anim.ledger.counting import SHOWN, film_shows, listed
from anim.ledger.turning import UP, axis, rotation, turned
from hfield.ledger.document import Propositions
from hfield.ledger.propositions import Assertion
from hfield.ledger.real_geometry import Angles
from hfield.ledger.scopes import InField
from hfield.syntax import Node, both, names, negation, number
from hfield.syntax import equal as same
from rotation.ledger.entries import ONE, ZERO, Vector, apply, equal, product, times
from rotation.ledger.matrix_functions import EULER
from rotation.ledger.symbolic_runs import code, coordinates
from rotation.ledger.symbolic_runs import equal as same_lists

QUARTERS = ((1, 0), (0, 1), (-1, 0), (0, -1))  # cos x and sin x for x = 0, π/2, π, 3π/2
P, S, T, Y = names("p s t y")
OF_R = {0: (ONE, ZERO), 1: (Y, S), -1: (Y, -S)}  # cosine and sine of 0, r and −r


def leaning(axes: str) -> Angles:
    """Return the claim that the Euler angle (0, r·sin x, r·cos x) tilts the top by r at every quarter turn x.

    The top leans towards (sin x, −cos x), a direction that turns with x.
    """
    equations = []
    for cos, sin in QUARTERS:
        angles = [OF_R[n] for n in (0, sin, cos)]
        tilt = times(*(rotation(a, *angle) for a, angle in zip(axes, angles, strict=True)))
        leaned = (product(number(sin), S), product(number(-cos), S), Y)
        equations.append(equal(apply(tilt, UP), leaned))
    words = (
        "for x = 0, π/2, π and 3π/2 the Euler angle (0, r·sin x, r·cos x) turns (0, 0, 1) into "
        "(sin r·sin x, −sin r·cos x, cos r)"
    )
    return Angles(Assertion.of(both(*equations), ("y**2 + s**2 == 1",), words))


# The last frame. x is 32π, so u = (r, 0, √(1 − r²)), r = 1/4, is the axis of the quaternions. The
# Euler angle is (0, 0, 1/2); s and t are the cosine and the sine of 1/2, which is not a multiple of
# π. The spin about z is applied first and does not move the top's axis.
AXIS = ("4*y == 1", "z**2 == 1 - y**2")
BY_EULER = turned((ONE, ZERO, ZERO), UP, S, T)


def by_quaternions(cosine: Node, sine: Node) -> Vector:
    """Return the top's axis in the last frame, if the angle about u has this cosine and sine."""
    return turned(axis(ONE, ZERO), UP, cosine, sine)


ALIKE = InField(
    "RR",
    Assertion.of(
        same(by_quaternions(ZERO, ONE)[0], BY_EULER[0]),
        AXIS,
        "in the last frame both ways turn the top's axis to a place with the same x",
    ),
)
APART = InField(
    "RR",
    Assertion.of(
        negation(equal(by_quaternions(P[0], P[1]), BY_EULER)),
        (*AXIS, "p[0]**2 + p[1]**2 == 1", "s**2 + t**2 == 1", "t != 0"),
        "in the last frame they turn the top's axis to different places, whatever the angle about u",
    ),
)

CIRCLES = tuple(f"{a}[0]**2 + {a}[1]**2 == 1" for a in "pqr")


def matrix_of(axes: str, *given: str) -> Assertion:
    """Return the claim that rotationMatrixZYX(ψ, φ, θ) rotates by its angles about these axes, the last
    first.
    """
    angles, turn = names("psi phi theta"), code("rotationbyMatrix")
    v = stepwise = coordinates("v")
    for letter, angle in reversed(list(zip(axes, angles, strict=True))):
        stepwise = turn(code(f"{letter}axisMatrixrotation", **EULER)(angle), stepwise)
    matrix = code("rotationMatrixZYX", **EULER)(*angles)
    words = f"rotationMatrixZYX(ψ, φ, θ) turns by ψ about {axes[0]}, φ about {axes[1]}, θ about {axes[2]}"
    return Assertion.of(same_lists(turn(matrix, v), stepwise), given, words)


COMPUTED = {
    "C3.4.3-a": Propositions(as_printed=leaning("zyx"), spoilt=leaning("zyz")),
    "C3.4.3-b": Propositions(as_printed=ALIKE, spoilt=APART, corrected=APART),
    "C3.4.3-c": Propositions(
        as_printed=listed(("0", "1/4"), 3, "euler_angle"),
        spoilt=listed(("0", "r sin x", "r cos x"), 3, "euler_angle"),
        corrected=listed(("0", "r sin x", "r cos x"), 3, "euler_angle"),
    ),
    "C3.4.3-d": Propositions(
        as_printed=matrix_of("zyz", *CIRCLES), spoilt=matrix_of("zyx"), corrected=matrix_of("zyx")
    ),
    "C3.4.3-e": Propositions(
        as_printed=listed(("speed", "euler_angle", "time"), 3, "the list of variables"),
        spoilt=listed(("speed", "angle", "axis_rotation", "time"), 3, "the list of variables"),
    ),
    "C3.4.3-f": Propositions(as_printed=film_shows(SHOWN), spoilt=film_shows((*SHOWN[1:], 499))),
}
