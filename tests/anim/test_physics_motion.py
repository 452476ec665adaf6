"""The heavy top against independent solutions of its equations, and against what is known of it."""

from math import cos, inf, pi, sin, sqrt

import numpy as np
import pytest

from anim.errors import AnimationError
from anim.film import Clip
from anim.model import Model
from anim.physics import Body, HeavyTop, Launch, physical
from anim.physics.heavy_top_equations import run, run_compiled, visit, visit_compiled
from anim.physics.launch import EVERY
from rotation.matrices import R_y, R_z, to_matrix
from tests.anim.steps import kept, visited

BODY = Body.turned(Model().profile)
FREE = Launch(spin=30.0, tilt=0.1, spin_decay=inf, tilt_decay=inf)
LAUNCHES = [
    FREE,
    Launch(spin=None, tilt=0.4, spin_decay=inf, tilt_decay=inf),
    Launch(spin=45.0, tilt=0.3, precession=2.0, spin_decay=inf, tilt_decay=inf),
    Launch(spin=-35.0, tilt=0.25, precession=1.0, spin_decay=inf, tilt_decay=inf),
    Launch(spin=60.0, tilt=0.7, precession=-1.0, gravity=1.62, spin_decay=inf, tilt_decay=inf),
]


def apart(p, q):
    """The angles between attitudes (n, 4), in radians."""
    near = np.minimum(np.linalg.norm(p - q, axis=1), np.linalg.norm(p + q, axis=1))
    return 4 * np.arcsin(near / 2)


def lagrange(top, times):
    """Solve the Lagrange equations in Euler angles z-y-z; return matrices (n, 3, 3)."""
    integrate = pytest.importorskip("scipy.integrate", reason="scipy solves the equations")
    body, launch = top.body, top.launch
    theta, phi_dot = launch.tilt, launch.precession
    p_psi = body.axial * top.spin
    p_phi = body.transverse * phi_dot * sin(theta) ** 2 + p_psi * cos(theta)

    def rates(_, y):
        _, tilt, _, swing = y
        phi_rate = (p_phi - p_psi * cos(tilt)) / (body.transverse * sin(tilt) ** 2)
        torque = (body.transverse * phi_rate**2 * cos(tilt) - p_psi * phi_rate + top.torque) * sin(
            tilt
        )
        return [
            phi_rate,
            swing,
            p_psi / body.axial - phi_rate * cos(tilt),
            torque / body.transverse,
        ]

    solution = integrate.solve_ivp(
        rates, (0, times[-1]), [0, theta, 0, 0], "DOP853", times, rtol=1e-13, atol=1e-13
    )
    phi, tilt, psi, _ = solution.y
    return R_z(phi) @ R_y(tilt) @ R_z(psi)


def euler_equations(top, times):
    """Solve the body-frame equations with friction; return states (n, 7)."""
    integrate = pytest.importorskip("scipy.integrate", reason="scipy solves the equations")
    i1, i3, mgl = top.body.transverse, top.body.axial, top.torque
    d1, d3 = 1 / top.launch.tilt_decay, 1 / top.launch.spin_decay

    def rates(_, y):
        w, a, b, c, o1, o2, o3 = y
        up1, up2 = 2 * (a * c - w * b), 2 * (b * c + w * a)
        return [
            (-a * o1 - b * o2 - c * o3) / 2,
            (w * o1 + b * o3 - c * o2) / 2,
            (w * o2 + c * o1 - a * o3) / 2,
            (w * o3 + a * o2 - b * o1) / 2,
            ((i1 - i3) * o2 * o3 + mgl * up2) / i1 - d1 * o1,
            ((i3 - i1) * o3 * o1 - mgl * up1) / i1 - d1 * o2,
            -d3 * o3,
        ]

    return integrate.solve_ivp(
        rates, (0, times[-1]), top.start, "DOP853", times, rtol=1e-12, atol=1e-13
    ).y.T


@pytest.mark.parametrize("launch", LAUNCHES)
def test_attitudes_follow_the_lagrange_equations_for_ten_seconds(launch):
    top = HeavyTop(BODY, launch, 10.0)
    times = np.linspace(0, 10, 101)
    if top.landed is not None:
        times = times[times < top.landed]
    ours, theirs = to_matrix(top(times)), lagrange(top, times)
    angles = 2 * np.arcsin(np.linalg.norm(ours - theirs, axis=(1, 2)) / sqrt(8))
    assert angles.max() < 1e-6


def test_friction_follows_the_equations_until_the_rim_touches():
    top = HeavyTop(BODY, Launch(), 10.0)
    times = np.linspace(0, top.landed, 50, endpoint=False)
    ours, theirs = top.states(times), euler_equations(top, times)
    assert apart(ours[:, :4], theirs[:, :4]).max() < 1e-6
    assert abs(ours[:, 4:] - theirs[:, 4:]).max() < 1e-5


@pytest.mark.parametrize("launch", LAUNCHES)
def test_energy_and_momentum_stay_over_a_hundred_thousand_steps(launch):
    step = HeavyTop(BODY, launch, 1.0).longest_step
    top = HeavyTop(BODY, launch, 99_999.5 * step)
    assert top.steps == 100_000
    states, landed = kept(run_compiled, top.start, top.step, top.steps, 1, top.rates)
    states = states if landed < 0 else states[: int(landed / top.step)]
    energies, momenta = top.energies(states), top.vertical_momenta(states)
    size = np.linalg.norm(states[0, 4:] * top.moments)
    assert abs(energies - energies[0]).max() < 1e-9 * top.torque
    assert abs(momenta - momenta[0]).max() < 1e-9 * size
    assert abs(states[:, 6] - top.spin).max() < 1e-9 * abs(top.spin)
    assert abs(np.linalg.norm(states[:, :4], axis=1) - 1).max() < 1e-14


@pytest.mark.parametrize(
    ("factor", "sleeps"), [(1.05, True), (1.01, True), (0.99, False), (0.9, False)]
)
def test_the_upright_top_sleeps_above_the_threshold_spin_only(factor, sleeps):
    still = Launch(tilt=1e-6, spin_decay=inf, tilt_decay=inf)
    spin = factor * HeavyTop(BODY, still, 1.0).sleeping_spin
    assert spin**2 == pytest.approx(
        factor**2 * 4 * BODY.mass * still.gravity * BODY.height * BODY.transverse / BODY.axial**2
    )
    top = HeavyTop(BODY, Launch(spin=spin, tilt=1e-6, spin_decay=inf, tilt_decay=inf), 30.0)
    states = top.states(np.linspace(0, 30, 600))
    tilts = 2 * np.hypot(states[:, 1], states[:, 2])
    assert bool(tilts.max() < 2e-5) is sleeps


def test_steady_precession_keeps_its_tilt_and_rate():
    tilt, spin = 0.3, 50.0
    still = HeavyTop(BODY, FREE, 1.0)
    # I₁Ω²cos θ − I₃ω₃Ω + mgl = 0: the slow root.
    a, b = BODY.transverse * cos(tilt), BODY.axial * spin
    rate = 2 * still.torque / (b + sqrt(b * b - 4 * a * still.torque))
    top = HeavyTop(BODY, Launch(spin, tilt, rate, spin_decay=inf, tilt_decay=inf), 5.0)
    times = np.linspace(0, 5, 101)
    axis = to_matrix(top(times))[:, :, 2]
    assert abs(np.arccos(axis[:, 2]) - tilt).max() < 1e-7
    around = np.unwrap(np.arctan2(axis[:, 1], axis[:, 0]))
    assert around == pytest.approx(rate * times, abs=1e-6)


def test_the_compiled_run_is_the_plain_one():
    top = HeavyTop(BODY, Launch(), 10.0)
    start, h, rates = top.start, top.step, top.rates
    plain, ours = (kept(f, start, h, 200, 10, rates) for f in (run, run_compiled))
    assert abs(plain[0] - ours[0]).max() < 1e-12
    assert plain[1] == ours[1] == -1
    times = np.linspace(0, 210 * h, 9)
    plain, ours = (
        visited(f, ours[0], 10 * h, times, h, 150 * h, rates) for f in (visit, visit_compiled)
    )
    assert abs(plain - ours).max() < 1e-12


def test_the_step_is_of_fourth_order():
    def end(steps):
        top = HeavyTop(BODY, FREE, 1.0)
        return kept(run_compiled, top.start, 1.0 / steps, steps, steps, top.rates)[0][-1, :4]

    best = end(4000)
    errors = [np.linalg.norm(end(n) - best) for n in (100, 200)]
    assert 12 < errors[0] / errors[1] < 20


@pytest.mark.parametrize("frames_apart", [EVERY / 2, 1.0])
def test_states_between_those_kept_are_reached_from_them(frames_apart):
    top = HeavyTop(BODY, Launch(), 10.0)
    times = np.arange(0, 9, frames_apart * top.step * 7)
    assert apart(top(times), euler_equations(top, times)[:, :4]).max() < 1e-6


def test_a_top_that_falls_rests_on_its_rim():
    top = HeavyTop(BODY, Launch(), 10.0)
    assert 8 < top.landed < 10
    times = np.array([top.landed - 1e-6, top.landed, top.landed + 0.1, 10.0])
    states = top.states(times)
    tilts = np.arccos(to_matrix(states[:, :4])[:, 2, 2])
    assert tilts == pytest.approx(np.full(4, pi / 4), abs=1e-5)
    assert tilts[1] == pytest.approx(pi / 4, abs=1e-9)
    assert np.all(states[1:, 4:] == 0)
    assert np.all(states[0, 4:] != 0)
    assert np.all(states[1] == states[2])
    assert np.all(to_matrix(states[:, :4])[:, 2, :] @ np.array([1, 0, 1]) >= -1e-6)


def test_without_gravity_and_friction_the_axis_goes_round_a_fixed_momentum():
    launch = Launch(20.0, 0.3, 3.0, gravity=0.0, spin_decay=inf, tilt_decay=inf)
    top = HeavyTop(BODY, launch, 3.0)
    states = top.states(np.linspace(0, 3, 50))
    momenta = np.einsum("nij,nj->ni", to_matrix(states[:, :4]), states[:, 4:] * top.moments)
    assert abs(momenta - momenta[0]).max() < 1e-12


def test_the_heading_turns_the_whole_motion_about_the_vertical() -> None:
    film = Clip(40, 20, 2.0)
    straight, turned = (physical(film, launch=Launch(heading=h)) for h in (0.0, 0.7))
    np.testing.assert_allclose(turned.matrices, R_z(0.7) @ straight.matrices, atol=1e-9)
    with pytest.raises(AnimationError, match="heading"):
        Launch(heading=float("nan"))
