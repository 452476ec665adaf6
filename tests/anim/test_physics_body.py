"""Mass, centre and moments of inertia against textbook solids and against sampled ones; launches."""

from math import inf, pi

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from anim.aliasing import apparent_spin
from anim.errors import AnimationError
from anim.film import clip
from anim.model import Model
from anim.physics import Body, HeavyTop, Launch, physical
from anim.physics.inertia import reach

CONE = [(0, 0), (1, 1)]
lengths = st.floats(0.1, 3)


@given(lengths, lengths, lengths)
def test_a_cone_on_its_tip(radius, height, mass):
    body = Body.turned([(0, 0), (radius, height), (0, height)], scale=2.0, mass=mass)
    r, h = 2 * radius, 2 * height
    assert body.mass == mass
    assert body.height == pytest.approx(3 / 4 * h)
    assert body.axial == pytest.approx(3 / 10 * mass * r * r)
    assert body.transverse == pytest.approx(mass * (3 / 20 * r * r + 3 / 5 * h * h))


@given(lengths, lengths, lengths)
def test_a_cylinder_above_the_tip(radius, low, tall):
    profile = [(0, low), (radius, low), (radius, low + tall), (0, low + tall)]
    body = Body.turned(profile, scale=1.0, density=3.0)
    mass = 3 * pi * radius**2 * tall
    assert body.mass == pytest.approx(mass)
    assert body.height == pytest.approx(low + tall / 2)
    assert body.axial == pytest.approx(mass * radius**2 / 2)
    inside = radius**2 / 4 + tall**2 / 12
    assert body.transverse == pytest.approx(mass * (inside + (low + tall / 2) ** 2))


@pytest.mark.parametrize("p2", ["printed", "third"])
def test_the_thesis_top_by_throwing_points_into_it(p2):
    profile = np.array(Model(p2=p2).profile)
    x, y, z = np.random.default_rng(7).uniform([-1, -1, 0], [1, 1, 3], (2_000_000, 3)).T
    inside = np.hypot(x, y) < np.interp(z, profile[:, 1], profile[:, 0])
    x, y, z = x[inside], y[inside], z[inside]
    body = Body.turned(Model(p2=p2).profile, scale=1.0, density=1.0)
    assert body.mass == pytest.approx(12 * inside.mean(), rel=5e-3)
    assert body.height == pytest.approx(z.mean(), rel=5e-3)
    assert body.axial / body.mass == pytest.approx((x * x + y * y).mean(), rel=5e-3)
    assert body.transverse / body.mass == pytest.approx((x * x + z * z).mean(), rel=5e-3)


def test_size_and_mass_scale_the_moments():
    small, large = (Body.turned(Model().profile, scale, mass) for scale, mass in ((0.1, 2), (1, 1)))
    assert small.axial == pytest.approx(0.02 * large.axial)
    assert small.transverse == pytest.approx(0.02 * large.transverse)
    assert small.height == pytest.approx(0.1 * large.height)
    assert small.reach == large.reach == pytest.approx(pi / 4)


@pytest.mark.parametrize(("p2", "degrees"), [("printed", 45), ("third", 45), (2.2, 26.565)])
def test_the_tilt_on_the_ground_is_computed(p2, degrees):
    model = Model(5000, p2=p2)
    tilt = reach(model.profile)
    assert np.degrees(tilt) == pytest.approx(degrees, abs=1e-3)
    for part, below in ((0.999, False), (1.001, True)):
        c, s = np.cos(part * tilt), np.sin(part * tilt)
        lowest = (model.points[1:, 2] * c - model.points[1:, 0] * s).min()
        assert (lowest < 0) == below


@pytest.mark.parametrize(
    ("values", "words"),
    [
        ({"scale": 0}, "scale is 0"),
        ({"mass": -1}, "mass is -1"),
        ({"density": inf}, "density is inf"),
        ({"mass": 1, "density": 1}, "both"),
        ({"profile": [(0, 0), (0, 1)]}, "no volume|not above the ground"),
        ({"profile": [(0, 0), (1, -0.1), (0, 1)]}, "not above the ground"),
    ],
)
def test_what_is_no_body_is_refused(values, words):
    with pytest.raises(AnimationError, match=words):
        Body.turned(**{"profile": Model().profile, **values})


@pytest.mark.parametrize(
    "values",
    [
        {"spin": float("nan")},
        {"tilt": -0.1},
        {"gravity": -9.8},
        {"spin_decay": 0},
        {"tilt_decay": -1},
        {"precession": inf},
    ],
)
def test_what_is_no_launch_is_refused(values):
    with pytest.raises(AnimationError):
        Launch(**values)


def test_absurd_launches_are_refused_before_any_work():
    body = Body.turned(Model().profile)
    with pytest.raises(AnimationError, match=r"the rim is on the ground at 45°"):
        HeavyTop(body, Launch(tilt=0.8), 10)
    with pytest.raises(AnimationError, match="steps"):
        HeavyTop(body, Launch(spin=1e9), 10)


def test_the_default_film_shows_a_top_that_precesses_nods_slows_and_falls():
    motion = physical()
    record = motion.record
    assert record is not None
    assert 8.5 < record.landed < 9.5
    standing = motion.times < record.landed
    axis = motion.apex(1.0)[standing]
    around = np.unwrap(np.arctan2(axis[:, 1], axis[:, 0]))
    assert around[-1] - around[0] > 4 * 2 * pi
    swings = np.diff(np.sign(np.diff(motion.tilts[standing])))
    assert np.count_nonzero(swings) > 5
    assert np.all(np.diff(record.spins[standing]) < 0)
    assert np.all(np.diff(record.energies) <= 0)
    assert motion.tilts[~standing] == pytest.approx(pi / 4, abs=1e-9)
    assert np.ptp(motion.matrices[~standing], axis=0).max() == 0
    assert apparent_spin(motion, 10).message() == ""
    for values in (record.energies, record.momenta, record.spins):
        assert values.shape == (500,)
        with pytest.raises(ValueError, match="read-only"):
            values[0] = 0


def test_mass_does_not_change_the_motion():
    light, heavy = (physical(body=Body.turned(Model().profile, mass=m)) for m in (0.01, 100))
    assert abs(light.matrices - heavy.matrices).max() < 1e-7
    assert heavy.record.energies == pytest.approx(1e4 * light.record.energies, rel=1e-7)


@pytest.mark.parametrize("frames", [1, 2, 7])
def test_few_frames_sample_the_same_motion(frames):
    whole, few = physical(), physical(clip(frames=frames))
    assert few.record.landed == whole.record.landed
    assert abs(few.at([5.0]) - whole.at([5.0])).max() == 0
    assert few.matrices[-1] == pytest.approx(whole.matrices[-1 if frames > 1 else 0], abs=1e-12)


def test_without_friction_it_does_not_slow():
    motion = physical(launch=Launch().without_friction())
    assert np.ptp(motion.record.spins) < 1e-12
    assert motion.record.landed is None
