"""Equations of motion of a free top on the ground: it slips, rises, falls and rolls on its rim.

No point is fixed. The outline's corners are circles rounded by a radius. Where one sinks below z = 0 by δ,
the ground exerts a normal force N = κδ^(3/2)(1 + cδ̇) (H. Hertz 1882; K. H. Hunt and F. R. E. Crossley,
"Coefficient of restitution interpreted as damping in vibroimpact", Journal of Applied Mechanics 42, 1975),
friction μN·v/√(v² + ε²) against the slip velocity v, and a couple with arm `rolling` against turning.
Everything is divided by the mass. A state (14,) consists of the attitude q, ω in body axes, the centre of
mass and its velocity in space, and the energy lost so far. Steps use the classical Runge–Kutta method of
fourth order.
"""

from math import ceil, sqrt
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from anim.compiling import called, kernel

Floats = NDArray[np.float64]

SIZE = 14
STIFF = 0.05
"""A step times the rate of friction, at most: what is longer is done in parts."""
AROUND, FINER = 30, 32
"""So many steps before and after a contact begins or ends the steps are so much finer."""
HEIGHT, LOST = 9, 13
"""Where in a state the height of the centre of mass is, and the energy lost, over the mass."""


def workspace() -> Floats:
    """Return the work arrays of the integrator, which kernels cannot allocate."""
    return np.empty((6, SIZE))


class Ground(NamedTuple):
    """The constants of the motion; moments, stiffness and energies are divided by the mass."""

    transverse: float
    """I₁ about the centre of mass, in m²."""
    axial: float
    gravity: float
    tumbling: float
    """How fast ω₁ and ω₂ decay without any ground, in s⁻¹."""
    spinning: float
    stiffness: float
    """κ in m^(−1/2)·s⁻²."""
    damping: float
    """c in s/m."""
    friction: float
    """μ, the coefficient of sliding friction."""
    creep: float
    """ε in m/s: friction is whole where the slip is much faster, and sticks to a creep below."""
    rolling: float
    """The arm in m of the couple with which the ground resists turning."""


@called
def slope(y: Floats, out: Floats, edges: Floats, ground: Ground) -> float:
    """Write the derivative of the state ``y`` into ``out``; ``edges`` (k, 3) are radius, height, rounding.

    Return an estimate of the rate, in s⁻¹, at which friction ends slipping and spinning. For slipping it is
    the force divided by the slip velocity, times the inverse of the effective mass at the contact, which is
    at most 1/m + s²/I.
    """
    i1, i3, gravity, tumbling, spinning, stiffness, damping, friction, creep, rolling = ground
    a, b, c, d = y[0], y[1], y[2], y[3]
    w1, w2, w3 = y[4], y[5], y[6]
    # The axes of space seen from the body are the rows of the rotation.
    r11, r12, r13 = a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)
    r21, r22, r23 = 2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b)
    g1, g2, g3 = 2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d
    v1 = r11 * y[10] + r21 * y[11] + g1 * y[12]
    v2 = r12 * y[10] + r22 * y[11] + g2 * y[12]
    v3 = r13 * y[10] + r23 * y[11] + g3 * y[12]
    side = sqrt(g1 * g1 + g2 * g2)
    f1 = f2 = f3 = t1 = t2 = t3 = stiff = 0.0
    lost = tumbling * i1 * (w1 * w1 + w2 * w2) + spinning * i3 * w3 * w3
    for k in range(len(edges)):
        radius, height, rounding = edges[k, 0], edges[k, 1], edges[k, 2]
        if radius > 0 and side < 1e-9:
            continue  # upright: all points of the circle are equally low, and none is on the ground
        out_of_axis = radius / side if radius > 0 else 0.0
        s1, s2 = -(out_of_axis + rounding) * g1, -(out_of_axis + rounding) * g2
        s3 = height - rounding * g3
        depth = -(y[HEIGHT] + s1 * g1 + s2 * g2 + s3 * g3)
        if depth <= 0:
            continue
        u1, u2, u3 = v1 + w2 * s3 - w3 * s2, v2 + w3 * s1 - w1 * s3, v3 + w1 * s2 - w2 * s1
        sinking = -(u1 * g1 + u2 * g2 + u3 * g3)
        elastic = stiffness * depth * sqrt(depth)
        press = max(0.0, elastic * (1 + damping * sinking))
        p1, p2, p3 = u1 + sinking * g1, u2 + sinking * g2, u3 + sinking * g3
        slip = p1 * p1 + p2 * p2 + p3 * p3
        grip = friction * press / sqrt(slip + creep * creep)
        turning = w1 * w1 + w2 * w2 + w3 * w3
        stay = rolling * press / sqrt(turning + 1.0)
        n1, n2, n3 = press * g1 - grip * p1, press * g2 - grip * p2, press * g3 - grip * p3
        f1, f2, f3 = f1 + n1, f2 + n2, f3 + n3
        t1 += s2 * n3 - s3 * n2 - stay * w1
        t2 += s3 * n1 - s1 * n3 - stay * w2
        t3 += s1 * n2 - s2 * n1 - stay * w3
        lost += (press - elastic) * sinking + grip * slip + stay * turning
        out_of_line = s1 * s1 + s2 * s2
        stiff += grip * (1 + (out_of_line + s3 * s3) / i1 + out_of_line / i3) + stay / min(i1, i3)
    out[0] = -(b * w1 + c * w2 + d * w3) / 2
    out[1] = (a * w1 + c * w3 - d * w2) / 2
    out[2] = (a * w2 + d * w1 - b * w3) / 2
    out[3] = (a * w3 + b * w2 - c * w1) / 2
    out[4] = ((i1 - i3) * w2 * w3 + t1) / i1 - tumbling * w1
    out[5] = ((i3 - i1) * w3 * w1 + t2) / i1 - tumbling * w2
    out[6] = t3 / i3 - spinning * w3
    out[7], out[8], out[9] = y[10], y[11], y[12]
    out[10] = r11 * f1 + r12 * f2 + r13 * f3
    out[11] = r21 * f1 + r22 * f2 + r23 * f3
    out[12] = g1 * f1 + g2 * f2 + g3 * f3 - gravity
    out[LOST] = lost
    return stiff


@called
def changes_contact(y: Floats, h: float, edges: Floats) -> bool:
    """Return whether one of the ``edges`` touches or leaves the ground within AROUND times ``h``."""
    g1, g2 = 2 * (y[1] * y[3] - y[0] * y[2]), 2 * (y[2] * y[3] + y[0] * y[1])
    g3, side = 1 - 2 * (y[1] * y[1] + y[2] * y[2]), sqrt(g1 * g1 + g2 * g2)
    rising = g1 * y[5] - g2 * y[4]  # of g3
    for k in range(len(edges)):
        radius, height, rounding = edges[k, 0], edges[k, 1], edges[k, 2]
        if radius > 0 and side < 1e-9:
            continue
        gap = y[HEIGHT] + height * g3 - radius * side - rounding
        outwards = radius * g3 / side if radius > 0 else 0.0
        if abs(gap) < AROUND * h * abs(y[12] + (height + outwards) * rising):
            return True
    return False


@called
def advance(y: Floats, h: float, work: Floats, edges: Floats, ground: Ground) -> None:
    """Advance the state ``y`` (14,) by ``h`` seconds, in place; ``work`` (6, 14) is overwritten.

    If friction is stiff the step is divided into parts no longer than STIFF over its rate, and into at least
    FINER parts if a contact begins or ends, because the ground's force is not smooth there.
    """
    parts = max(1, ceil(h * slope(y, work[0], edges, ground) / STIFF))
    if changes_contact(y, h, edges):
        parts = max(parts, FINER)
    step = h / parts
    for part in range(parts):
        if part > 0:
            slope(y, work[0], edges, ground)
        for k in range(1, 4):
            share = step if k == 3 else step / 2
            for n in range(SIZE):
                work[4, n] = y[n] + share * work[k - 1, n]
            slope(work[4], work[k], edges, ground)
        for n in range(SIZE):
            y[n] += step / 6 * (work[0, n] + 2 * work[1, n] + 2 * work[2, n] + work[3, n])
    size = sqrt(y[0] * y[0] + y[1] * y[1] + y[2] * y[2] + y[3] * y[3])
    for n in range(4):
        y[n] /= size


@called
def down(y: Floats, edges: Floats) -> bool:
    """Return whether an edge other than the first (the tip) touches the ground."""
    g3 = 1 - 2 * (y[1] * y[1] + y[2] * y[2])
    side = sqrt(max(0.0, 1 - g3 * g3))
    for k in range(1, len(edges)):
        if y[HEIGHT] + edges[k, 1] * g3 - edges[k, 0] * side - edges[k, 2] < 0:
            return True
    return False


def follow(
    states: Floats,
    start: Floats,
    h: float,
    steps: int,
    every: int,
    edges: Floats,
    ground: Ground,
    work: Floats,
) -> float:
    """Write ``states`` (steps // every + 1, 14) from ``start``; return when the rim first touched, or −1.

    ``work`` (6, 14) is overwritten.
    """
    y = work[5]
    for n in range(SIZE):
        y[n] = start[n]
    landed = -1.0
    for step in range(steps + 1):
        if step % every == 0:
            for n in range(SIZE):
                states[step // every, n] = y[n]
        if landed < 0 and down(y, edges):
            landed = step * h
        advance(y, h, work, edges, ground)
    return landed


def meet(
    found: Floats,
    states: Floats,
    spacing: float,
    times: Floats,
    h: float,
    edges: Floats,
    ground: Ground,
    work: Floats,
) -> None:
    """Write the states ``found`` (n, 14) at ``times`` (n,), each computed from the last stored state before
    it.

    The stored ``states`` are ``spacing`` apart; ``work`` (6, 14) is overwritten.
    """
    for n in range(len(times)):
        last = min(int(times[n] / spacing), len(states) - 1)
        y = found[n]
        for k in range(SIZE):
            y[k] = states[last, k]
        whole = int((times[n] - last * spacing) / h)
        for _ in range(whole):
            advance(y, h, work, edges, ground)
        advance(y, times[n] - last * spacing - whole * h, work, edges, ground)


follow_compiled = kernel(follow)
meet_compiled = kernel(meet)
