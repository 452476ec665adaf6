"""The four pipelines against the thesis's own functions on lists, and against each other."""

from math import cos, pi, sin, sqrt

import numpy as np
import pytest

from anim.errors import AnimationError
from anim.film import clip
from anim.pipelines import PIPELINES, compare, kinematic
from anim.timeline import Timeline
from rotation import thesis
from tests.subcases import subcases

POINTS = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.3, -0.2, 3.0]]


def frames(count):
    """The parameters of the thesis's loop: spin, axis, and Euler angles by plain arithmetic."""
    for n in range(count):
        part = n / (count - 1)
        x, r = 32 * pi * part, part / 4
        speed = 16 * pi + (pi / 8 - 16 * pi) * part
        axis = [r * cos(x), r * sin(x), sqrt(1 - r * r)]
        yield speed, axis, [0.0, part / 2 * sin(x), part / 2 * cos(x)]


def spin3d(speed, axis, _euler, point):
    return thesis.rotationquaternion(
        pi / 2, axis, thesis.rotationquaternion(speed, [0, 0, 1], point)
    )


def product(speed, axis):
    spin = cos(speed / 2), [0, 0, sin(speed / 2)]
    tilt = cos(pi / 4), thesis.scalarVector(sin(pi / 4), axis)
    return thesis.multiQuaternion(*tilt, *spin)


def spin3d_optimized(speed, axis, _euler, point):
    return thesis.rotationquaternionChaged(*product(speed, axis), point)


def spin3d_matrix(speed, _axis, euler, point):
    turned = thesis.rotationbyMatrix(thesis.zaxisMatrixrotation(speed), point)
    return thesis.rotationbyMatrix(thesis.rotationMatrixZYX(*euler), turned)


def spin3d_matrix_from_quaternion(speed, axis, _euler, point):
    scalar, vector = product(speed, axis)
    length = sqrt(thesis.dotProduct(vector, vector))
    angle = 2 * np.arctan2(length, scalar)
    return thesis.rotationbyMatrix(thesis.rotationMatrixFromQuaternion(angle, vector), point)


BY_HAND = {
    "quaternions": spin3d,
    "product": spin3d_optimized,
    "euler": spin3d_matrix,
    "matrix": spin3d_matrix_from_quaternion,
}


@pytest.mark.parametrize("pipeline", PIPELINES)
def test_every_frame_is_that_of_the_thesis_functions(pipeline):
    motion = kinematic(pipeline, clip(frames=500))
    wanted = [[BY_HAND[pipeline](*now, p) for p in POINTS] for now in frames(500)]
    ours = np.array(POINTS) @ np.swapaxes(motion.matrices, 1, 2)
    assert abs(ours - wanted).max() < 1e-13


@subcases("angle", ["quarter", "half", "axis"])
@subcases("order", ["spin-first", "tilt-first"])
@subcases("spin", ["absolute", "accumulated"])
def test_the_quaternion_pipelines_agree_to_rounding_and_euler_does_not(angle, order, spin):
    together = compare(reading=Timeline(spin, order, angle))
    for first in ("quaternions", "product", "matrix"):
        for second in ("quaternions", "product", "matrix"):
            assert together.agree(first, second)
        assert not together.agree(first, "euler")
        assert together.axes[together.names.index(first), 2] > 0.3


def test_the_tilts_in_the_end():
    quarter, half = compare(), compare(reading=Timeline(angle="half"))
    # A turn by π/2 about an axis at the angle β from z brings z to cos θ = cos²β, one by π to θ = 2β.
    assert quarter.tilts[0] == pytest.approx(np.arccos(1 - 1 / 16))
    assert half.tilts[0] == pytest.approx(2 * np.arcsin(1 / 4))
    assert quarter.tilts[2] == pytest.approx(1 / 2)
    assert "28.65°" in quarter.table()
    assert quarter.table().count("90.00°") == 6


def test_with_a_half_turn_the_euler_axis_follows_a_quarter_behind():
    half = kinematic("product", reading=Timeline(angle="half")).apex(1.0)
    euler = kinematic("euler").apex(1.0)
    behind = np.column_stack([half[:, 1], -half[:, 0], half[:, 2]])
    assert np.degrees(np.linalg.norm(behind - euler, axis=1).max()) < 1.1


def test_the_formula_turns_in_the_other_order():
    words, formula = (
        kinematic("product", reading=Timeline(order=order)).matrices
        for order in ("spin-first", "tilt-first")
    )
    now = Timeline().at(np.linspace(0, 1, 500), 10)
    for n in (0, 123, 499):
        spin = np.array(thesis.zaxisMatrixrotation(now.spin[n]))
        tilt = np.array(thesis.rotationMatrixFromQuaternion(pi / 2, list(now.axes[n])))
        assert abs(words[n] - tilt @ spin).max() < 1e-13
        assert abs(formula[n] - spin @ tilt).max() < 1e-13


def test_the_literal_euler_angles_rock_the_top_in_one_plane():
    apex = kinematic("euler", reading=Timeline(euler="zyz")).apex()
    assert abs(apex[:, 1]).max() < 1e-12
    assert apex[:, 0].min() < -1 < 1 < apex[:, 0].max()


def test_an_unknown_pipeline_is_refused():
    with pytest.raises(AnimationError, match="expected one of quaternions, product, euler, matrix"):
        kinematic("lisp")
