"""The integrator of the page, in JavaScript, against Python's and against Jacobi's elliptic functions."""

import json
import shutil
import subprocess
from math import cos, inf, sin, sqrt
from pathlib import Path

import numpy as np
import pytest

import anim.viewer
from anim.model import Model
from anim.physics import Body, Contact, FreeTop, HeavyTop, Launch
from anim.physics.free_top_equations import follow_compiled
from anim.physics.heavy_top_equations import run_compiled
from tests.anim.steps import kept
from tests.anim.test_physics_motion import LAUNCHES
from tests.patience import PATIENCE
from tests.subcases import subcases

NODE = shutil.which("node")
SOURCES = [Path(anim.viewer.__file__).parent / name for name in ("heavy_top.js", "free_top.js")]
PROFILE = Model().profile
BODY = Body.turned(PROFILE)
TEN = [
    *LAUNCHES,
    Launch(),
    Launch(spin=20.0, tilt=0.3),
    Launch(spin=-50.0, tilt=0.5, precession=1.5, spin_decay=5.0),
    Launch(spin=0.0, tilt=0.2, tilt_decay=inf),
    Launch(spin=15.0, tilt=0.6, gravity=0.0, heading=2.0),
]

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(NODE is None, reason="needs node (Debian: nodejs)"),
]


def javascript(program: str, **data):
    """Run a program after the page's integrator, with ``data`` at hand; return what its last line gives."""
    assert NODE
    source = "\n".join(file.read_text() for file in SOURCES)
    text = f"{source}\nconst data = {json.dumps(data)};\n{program}"
    done = subprocess.run([NODE, "-"], input=text, capture_output=True, text=True, timeout=PATIENCE)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


def body_of(body):
    return {n: getattr(body, n) for n in ("mass", "height", "axial", "transverse", "reach")}


def losses_of(launch):
    return [1 / launch.tilt_decay, 1 / launch.spin_decay]


RUN = """
const { launch, body, losses, gravity, h, steps, every } = data, rates = ratesOf(body, gravity, losses);
let state = launched(launch), landed = -1;
const rows = [];
for (let n = 0; n <= steps; n++) {
  if (n % every === 0) rows.push([...state.q, ...state.w]);
  if (landed >= 0) continue;
  const next = stepToGround(state, h, rates);
  if (next.rest !== null) landed = n * h + next.rest;
  state = next;
}
console.log(JSON.stringify({ rows, landed }));
"""


def follow(top, h, steps, every):
    launch = {n: getattr(top.launch, n) for n in ("tilt", "precession", "heading")}
    return javascript(
        RUN,
        launch={"spin": top.spin, **launch},
        body=body_of(top.body),
        losses=losses_of(top.launch),
        gravity=top.launch.gravity,
        h=h,
        steps=steps,
        every=every,
    )


@subcases("launch", TEN)
def test_ten_launches_go_as_in_python_for_ten_seconds(launch):
    top = HeavyTop(BODY, launch, 10.0)
    states, landed = kept(run_compiled, top.start, top.step, top.steps, 16, top.rates)
    found = follow(top, top.step, top.steps, 16)
    assert found["landed"] == pytest.approx(landed, abs=1e-9)
    assert abs(np.array(found["rows"]) - states).max() < 1e-9


@pytest.mark.parametrize("launch", LAUNCHES[:2])
def test_the_tilt_is_jacobis_elliptic_function(launch):
    """E. T. Whittaker, Analytical Dynamics, §71: cos θ of a top let go is u₁ + (u₂ − u₁) sn²."""
    special = pytest.importorskip("scipy.special", reason="scipy has the elliptic functions")
    top = HeavyTop(BODY, launch, 10.0)
    a = 2 * top.torque / BODY.transverse
    b, u0 = BODY.axial * top.spin / BODY.transverse, cos(launch.tilt)
    # u̇² = (u₀ − u)·(a(1 − u²) − b²(u₀ − u)); u₀ is the upper turning point, the others are these.
    half = b * b / (2 * a)
    root = sqrt(half * half - 2 * half * u0 + 1)
    lower, outside = half - root, half + root
    modulus = (u0 - lower) / (outside - lower)
    steps, every = 40_000, 400
    times = np.arange(0, steps + 1, every) * (10.0 / steps)
    phase = special.ellipk(modulus) + sqrt(a * (outside - lower)) / 2 * times
    exact = lower + (u0 - lower) * special.ellipj(phase, modulus)[0] ** 2
    rows = np.array(follow(top, 10.0 / steps, steps, every)["rows"])
    ours = 1 - 2 * (rows[:, 1] ** 2 + rows[:, 2] ** 2)
    assert np.ptp(exact) > 1e-2
    assert abs(ours - exact).max() < 1e-9


@pytest.mark.parametrize("width", [1.0, 0.6, 1.4])
def test_a_widened_body_is_the_body_of_the_widened_outline(width):
    wide = Body.turned([(r * width, z) for r, z in PROFILE])
    found = javascript(
        "console.log(JSON.stringify(widenedBody(data.body, data.profile, data.width)))",
        body=body_of(BODY),
        profile=PROFILE,
        width=width,
    )
    assert found.pop("unit") == pytest.approx(0.5, rel=1e-14)
    assert found == pytest.approx(body_of(wide), rel=1e-14)


def test_energy_and_momentum_are_those_of_python():
    top = HeavyTop(BODY, Launch(spin=40.0, tilt=0.4, precession=2.0), 1.0)
    states = top.states(np.array([0.7]))
    found = javascript(
        "console.log(JSON.stringify(quantities(data.state, data.body, data.gravity)))",
        state={"q": states[0, :4].tolist(), "w": states[0, 4:].tolist()},
        body=body_of(BODY),
        gravity=top.launch.gravity,
    )
    assert found["energy"] == pytest.approx(top.energies(states)[0], rel=1e-13)
    assert found["about"] == pytest.approx(top.vertical_momenta(states)[0], rel=1e-13)
    assert found["momentum"][2] == pytest.approx(found["about"], rel=1e-13)
    assert np.linalg.norm(found["velocity"]) == pytest.approx(np.linalg.norm(states[0, 4:]))
    assert sin(found["tilt"] / 2) ** 2 == pytest.approx(states[0, 1] ** 2 + states[0, 2] ** 2)


FREE = [
    (Launch(spin=45.0, tilt=0.35, spin_decay=inf, tilt_decay=inf), Contact(0.05, 0.3)),
    (Launch(spin=60.0, tilt=0.5, spin_decay=inf, tilt_decay=inf), Contact(0.1, 0.03)),
    (Launch(spin=-40.0, tilt=0.3, precession=2.0, heading=1.0), Contact(0.03, 0.1, 0.002)),
    (Launch(spin=30.0, tilt=0.3, gravity=1.62), Contact(0.04, 0.0)),
    (Launch(spin=36.0, tilt=0.2, spin_decay=20.0), Contact(0.04, 0.4, 0.01)),
]
FOLLOW = """
const { launch, body, losses, gravity, outline, contact, h, steps, every } = data;
const edges = edgesOf(body, outline, contact.radius), ground = groundOf(body, gravity, losses, contact);
let state = letGo(launched(launch), body, contact.radius, gravity), landed = -1;
const rows = [];
for (let n = 0; n <= steps; n++) {
  if (n % every === 0) rows.push([...state.y]);
  if (landed < 0 && isDown(state, edges)) landed = n * h;
  state = stepOnGround(state, h, edges, ground);
}
const last = free(Float64Array.from(rows.at(-1)));
const found = freeQuantities(last, body, edges, ground);
console.log(JSON.stringify({ rows, landed, tip: tipOf(last, body), ...found }));
"""


@pytest.mark.parametrize(("launch", "contact"), FREE)
def test_a_free_top_goes_as_in_python_for_ten_seconds(launch, contact):
    top = FreeTop(BODY, launch, 10.0, contact)
    every = 64
    arguments = top.start, top.step, top.steps, every, top.edges, top.ground
    states, landed = kept(follow_compiled, *arguments)
    found = javascript(
        FOLLOW,
        launch={
            "spin": top.spin,
            **{n: getattr(launch, n) for n in ("tilt", "precession", "heading")},
        },
        body={**body_of(BODY), "unit": BODY.unit},
        outline=BODY.outline,
        losses=losses_of(launch),
        gravity=launch.gravity,
        contact=vars(contact),
        h=top.step,
        steps=top.steps,
        every=every,
    )
    rows = np.array(found["rows"])
    assert found["landed"] == pytest.approx(landed, abs=top.step * 1.01)
    assert abs(rows - states).max() < 1e-9
    last = rows[-1:]
    assert found["energy"] == pytest.approx(top.energies(last)[0], rel=1e-12)
    assert found["lost"] == pytest.approx(top.losses(last)[0], rel=1e-12)
    assert found["jellett"] == pytest.approx(top.jellett(last)[0], rel=1e-12)
    assert found["momentum"] == pytest.approx(top.momenta(last)[0], abs=1e-12)
    axis = np.array([2 * (last[0, 1] * last[0, 3] + last[0, 0] * last[0, 2])])
    assert found["tip"][0] == pytest.approx(
        (last[0, 7] - BODY.height * axis[0]) / BODY.unit, abs=1e-12
    )
