"""Section 3.4.1: the motion by two quaternions.

The axis of the second rotation is u = (r·cos x, r·sin x, √(1 − r²)). Here y is r, z is the root, and (p[0],
p[1]) is the point (cos x, sin x) of the circle, so there is an algebraic core over every commutative ring. A
rotation is given by the cosine and the sine of its angle, with Rodrigues' formula.
"""

from anim.ledger.counting import SHOWN, film_shows, listed, loop
from anim.ledger.turning import UP, axis, rotation, turned
from hfield.ledger.claim import Computed, ComputedResult
from hfield.ledger.document import Propositions
from hfield.ledger.propositions import Assertion, Every, written
from hfield.ledger.real_geometry import Angles
from hfield.ledger.scopes import InField
from hfield.syntax import Node, both, conj, names, norm, number
from hfield.syntax import equal as same
from rotation.ledger.entries import ONE, ZERO, Vector, apply, equal
from rotation.ledger.inequalities import Less, between
from rotation.ledger.quaternion_functions import CIRCLE, HALF, TURNED, UNIT, Q, S, T, rodrigues
from rotation.ledger.symbolic_runs import code, quaternion, read_as
from rotation.ledger.symbolic_runs import equal as same_lists

ON_CIRCLE = "p[0]**2 + p[1]**2 == 1"
ROOT = "z**2 == 1 - y**2"
P, K, Y, Z, ANGLE = names("p k y z angle")
U = axis(P[0], P[1])
LEANING = turned(U, UP, ZERO, ONE)  # by π/2
AT_FIRST = turned(axis(ONE, ZERO), UP, ZERO, ONE)


def tilted_without_spin(own: Node) -> Angles:
    """Return the claim that 1 + u, the rotation by π/2 about u, is a rotation by ``own`` followed by a tilt.

    ``own`` is a rotation about the top's own axis k, the same for every x. A tilt is a rotation about a
    horizontal axis: the product of 1 + u and the conjugate of ``own`` has k coordinate 0.
    """
    attitude = quaternion(1, U)
    tilt = attitude * conj(own)
    return Angles(
        Assertion.of(
            both(same(tilt[3], 0), same(tilt * own, norm(own) * attitude)),
            words="for every x the rotation by π/2 about u is the turn of the top about its own axis by "
            "1 + √(1−r²)·k, the same for all x, and then a tilt about a horizontal axis",
        )
    )


def precession(cosine: Node, sine: Node) -> Angles:
    """Return the claim that the top's axis at angle x is the axis at 0 rotated about the vertical.

    The rotation is by x if the cosine and sine are those of x.
    """
    return Angles(
        Assertion.of(
            equal(LEANING, apply(rotation("z", cosine, sine), AT_FIRST)), (ON_CIRCLE, ROOT)
        )
    )


def height(of_apex: Node) -> Every:
    """Return the claim for the height of the unit vector's end on the top's axis; the top is upright for r =
    0.
    """
    upright = Assertion.of(equal(LEANING, UP), ("y == 0", "z == 1"))
    return Every((Assertion.of(same(LEANING[2], of_apex), (ROOT,)), upright))


# spin3d on terms: s and t are the cosine and sine of half an angle.
SPUN = code("rotationquaternion", **HALF)(ANGLE, [0, 0, 1], Q)
DOUBLE = {
    "cos": read_as({"angle": "s**2 - t**2"}),
    "sin": read_as({"angle": "2*s*t"}),
}


def spin_about(letter: str) -> Every:
    """Return the claim that ``speed`` and ``angle`` are angles about the axis ``letter`` and
    ``axis_rotation``.
    """
    matrix = code(f"{letter}axisMatrixrotation", **DOUBLE)(ANGLE)
    spins = same_lists(SPUN, code("rotationbyMatrix")(matrix, Q))
    return Every(
        (
            Assertion.of(
                spins,
                (CIRCLE,),
                f"rotationquaternion(speed, [0, 0, 1], x) turns x about the {letter} axis by speed",
            ),
            Assertion.of(
                same(TURNED, rodrigues(S**2 - T**2, 2 * S * T)),
                (CIRCLE, UNIT),
                "rotationquaternion(angle, u, x) turns x about u by angle if |u| = 1",
            ),
        )
    )


def drawn(falling: bool) -> Computed:
    """Return the claim for the values of :class:`anim.timeline.Timeline` in 500 frames; ``falling`` is the
    speed.

    There are 500 values of each parameter, equally spaced up to rounding, from one end of the printed
    interval to the other.
    """

    def check_claim() -> ComputedResult:
        import numpy as np

        from anim.timeline import Timeline

        now = Timeline().at(np.linspace(0, 1, 500), 10.0)
        radius = np.hypot(now.axes[:, 0], now.axes[:, 1])
        turn = np.unwrap(np.arctan2(now.axes[1:, 1], now.axes[1:, 0]))  # r is 0 at first
        speed = (np.pi / 8, 16 * np.pi)
        wanted = {
            "axisAngle": (turn, np.linspace(0, 32 * np.pi, 500)[1:]),
            "radius": (radius, np.linspace(0, 1 / 4, 500)),
            "speedValue": (now.spin, np.linspace(*(speed[::-1] if falling else speed), 500)),
        }
        off = {name: float(abs(a - b).max()) for name, (a, b) in wanted.items()}
        steps = tuple(f"{name}: at most {most:.1e} from its place" for name, most in off.items())
        return ComputedResult(
            max(off.values()) < 1e-12, steps, {"off": [f"{max(off.values()):.3g}"]}
        )

    order = "decreasing" if falling else "increasing"
    return Computed(
        f"500 values each of [0, 32π], [0, 1/4] and [π/8, 16π], equally spaced, the last {order}",
        check_claim,
    )


def spin(frame: Node) -> Node:
    """Return the angle of the spin in a frame, in units of π: from 16 to 1/8 in 499 equal steps."""
    return 16 - frame * (16 - number(1) / 8) / 499


def turn(frame: Node) -> Node:
    """Return by how much the spin's angle decreases from one frame to the next."""
    return spin(frame) - spin(frame + 1)


FIRST_TURN, LAST_TURN = "the turn from frame 0 to 1", "the turn from frame 498 to 499"
SLOWER = Less(written(turn(number(498))), written(turn(ZERO)), f"{LAST_TURN} < {FIRST_TURN}")
LARGER = Less(
    written(spin(number(499))), written(spin(ZERO)), "the angle in frame 499 < the angle in frame 0"
)
CONSTANT = Assertion.of(
    same(turn(S), turn(ZERO)), (), "the turn from each frame to the next is the same"
)


def azimuth_steps(parts: int) -> InField:
    """Return the claim that 32π in so many steps is 11.54° per step, and 16 turns in total."""
    whole = Assertion(f"{parts}*(32/{parts}) == 2*16")
    degrees = between("11.535", f"180*32/{parts}", "11.545", "the step in degrees")
    return InField("QQ", Every((whole, degrees)))


def unit(vector: Vector) -> Angles:
    """Return the claim that an axis has length 1."""
    x, y, z = vector
    return Angles(Assertion.of(same(x**2 + y**2 + z**2, 1), (ON_CIRCLE, ROOT)))


FILM = "500*20 == 10*1000 and 1000/20 == 50"

COMPUTED = {
    "C3.4.1-a": Propositions(as_printed=unit(U), spoilt=unit((U[0], U[1], Y))),
    "C3.4.1-b": Propositions(as_printed=precession(P[0], P[1]), spoilt=precession(P[0], -P[1])),
    "C3.4.1-c": Propositions(
        as_printed=tilted_without_spin(1 + Z * K), spoilt=tilted_without_spin(1 - Z * K)
    ),
    "C3.4.1-d": Propositions(as_printed=height(1 - Y**2), spoilt=height(1 + Y**2)),
    "C3.4.1-e": Propositions(
        as_printed=listed(("speed", "angle", "axis_rotation", "time"), 4, "the list of variables"),
        spoilt=listed(("speed", "axis_rotation", "time"), 4, "the list of variables"),
    ),
    "C3.4.1-f": Propositions(as_printed=spin_about("z"), spoilt=spin_about("y")),
    "C3.4.1-h": Propositions(
        as_printed=InField("QQ", Assertion(FILM)),
        spoilt=InField("QQ", Assertion(FILM.replace("20", "25"))),
    ),
    "C3.4.1-i": Propositions(as_printed=drawn(falling=True), spoilt=drawn(falling=False)),
    "C3.4.1-j": Propositions(
        as_printed=InField("QQ", Every((LARGER, SLOWER))),
        spoilt=InField("QQ", Every((LARGER, CONSTANT))),
        corrected=InField("QQ", Every((LARGER, CONSTANT))),
    ),
    "C3.4.1-k": Propositions(as_printed=azimuth_steps(499), spoilt=azimuth_steps(500)),
    "C3.4.1-l": Propositions(as_printed=loop(499), spoilt=loop(500)),
    "C3.4.1-m": Propositions(
        as_printed=film_shows(SHOWN), spoilt=film_shows((0, *range(50, 500, 50)))
    ),
}
