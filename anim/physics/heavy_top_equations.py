"""Integrate the heavy symmetric top in steps, compiled or in plain Python from the same source.

The state is the attitude q, a unit quaternion, and the angular velocity ω in body axes. Let Γ = R⁻¹e_z be the
vertical in body axes. Then

    q̇ = ½qω,   I₁ω̇₁ = (I₁ − I₃)ω₂ω₃ + mgl·Γ₂ − k₁ω₁,   I₁ω̇₂ = (I₃ − I₁)ω₃ω₁ − mgl·Γ₁ − k₁ω₂,   I₃ω̇₃ = −k₃ω₃.

The flows of friction alone, of gravity alone (with constant attitude) and of the free top are each computed
exactly. Their symmetric composition has second order; three of these with Yoshida's steps have fourth order
(H. Yoshida, "Construction of higher order symplectic integrators", Physics Letters A 150, 1990). Without
friction the method is symplectic and preserves L_z and ω₃ up to rounding.
"""

from math import cos, exp, sin, sqrt
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from anim.compiling import called, kernel
from hfield.core.product import Constants, conjugate, multiply

Floats = NDArray[np.float64]
Four = tuple[float, float, float, float]
Three = tuple[float, float, float]

HAMILTON = Constants(-1.0, 0.0, -1.0)
OUTER = 1 / (2 - 2 ** (1 / 3))
INNER = 1 - 2 * OUTER
HALVINGS = 60


class Rates(NamedTuple):
    """The top's constants, divided by its moments of inertia."""

    shape: float
    """I₃/I₁."""
    gravity: float
    """mgl/I₁ in s⁻²."""
    tumbling: float
    """k₁/I₁ in s⁻¹."""
    spinning: float
    """k₃/I₃ in s⁻¹."""
    floor: float
    """The cosine of the tilt at which the rim touches the ground."""


called(multiply)  # the one product of quaternions
called(conjugate)


@called
def vertical(q: Four) -> Three:
    """Return Γ, the upward unit vector in body axes: the vector part of q̄·k·q."""
    half = multiply(HAMILTON, conjugate(HAMILTON, q), (0.0, 0.0, 0.0, 1.0))
    _, x, y, z = multiply(HAMILTON, half, q)
    return x, y, z


@called
def rotor(x: float, y: float, z: float) -> Four:
    """Return the quaternion of the rotation vector (x, y, z)."""
    angle = sqrt(x * x + y * y + z * z)
    half = angle / 2
    ratio = 0.5 - half * half / 12 if half < 1e-4 else sin(half) / angle
    return cos(half), x * ratio, y * ratio, z * ratio


@called
def second_order(q: Four, w: Three, h: float, rates: Rates) -> tuple[Four, Three]:
    """Return the state after ``h`` seconds: half friction, half gravity, free top, half gravity, half
    friction.
    """
    shape, gravity, tumbling, spinning, _ = rates
    w1, w2, w3 = w
    across, along = exp(-tumbling * h / 2), exp(-spinning * h / 2)
    pull = gravity * h / 2

    g1, g2, _ = vertical(q)
    w1, w2, w3 = w1 * across + pull * g2, w2 * across - pull * g1, w3 * along

    # The free top turns about its fixed angular momentum, and in itself about its axis at the rate `own`.
    own = (1 - shape) * w3 * h
    q = multiply(HAMILTON, q, rotor(w1 * h, w2 * h, shape * w3 * h))
    q = multiply(HAMILTON, q, (cos(own / 2), 0.0, 0.0, sin(own / 2)))
    c, s = cos(own), sin(own)
    w1, w2 = c * w1 + s * w2, c * w2 - s * w1

    g1, g2, _ = vertical(q)
    return q, ((w1 + pull * g2) * across, (w2 - pull * g1) * across, w3 * along)


@called
def fourth_order(q: Four, w: Three, h: float, rates: Rates) -> tuple[Four, Three]:
    """Return the state after ``h`` seconds by Yoshida's composition, with a quaternion of norm 1."""
    q, w = second_order(q, w, OUTER * h, rates)
    q, w = second_order(q, w, INNER * h, rates)
    q, w = second_order(q, w, OUTER * h, rates)
    a, b, c, d = q
    steady = (3 - (a * a + b * b + c * c + d * d)) / 2  # 1/|q| to first order
    return (a * steady, b * steady, c * steady, d * steady), w


@called
def touching(q: Four, w: Three, h: float, rates: Rates) -> float:
    """Return the time within ``h`` seconds at which the tilt reaches the floor, by bisection."""
    before, after = 0.0, h
    for _ in range(HALVINGS):
        middle = (before + after) / 2
        there, _w = fourth_order(q, w, middle, rates)
        if vertical(there)[2] < rates.floor:
            after = middle
        else:
            before = middle
    return before


def run(states: Floats, start: Floats, h: float, steps: int, every: int, rates: Rates) -> float:
    """Write ``states`` (steps // every + 1, 7) from ``start`` (7,); return when the rim touched, or −1.

    A state is (w, x, y, z, ω₁, ω₂, ω₃). After the touch the top stays where it fell.
    """
    q = (start[0], start[1], start[2], start[3])
    w = (start[4], start[5], start[6])
    landed = 0.0 if vertical(q)[2] < rates.floor else -1.0
    for step in range(steps + 1):
        if step % every == 0:
            row = states[step // every]
            row[0], row[1], row[2], row[3] = q
            row[4], row[5], row[6] = w
        if landed < 0:
            there, then = fourth_order(q, w, h, rates)
            if vertical(there)[2] < rates.floor:
                rest = touching(q, w, h, rates)
                landed = step * h + rest
                there, then = fourth_order(q, w, rest, rates)
            q, w = there, then
        if landed >= 0:
            w = (0.0, 0.0, 0.0)
    return landed


def visit(
    found: Floats,
    states: Floats,
    spacing: float,
    times: Floats,
    h: float,
    landed: float,
    rates: Rates,
) -> None:
    """Write the states ``found`` (n, 7) at ``times`` (n,), each computed from the last stored state before
    it.

    The stored ``states`` are ``spacing`` apart; ``landed`` is the time at which the rim touches, or infinity.
    """
    for n in range(len(times)):
        moment = min(times[n], landed)
        last = min(int(moment / spacing), len(states) - 1)
        row = states[last]
        q = (row[0], row[1], row[2], row[3])
        w = (row[4], row[5], row[6])
        whole = int((moment - last * spacing) / h)
        for _ in range(whole):
            q, w = fourth_order(q, w, h, rates)
        q, w = fourth_order(q, w, moment - last * spacing - whole * h, rates)
        if times[n] >= landed:
            w = (0.0, 0.0, 0.0)
        found[n, 0], found[n, 1], found[n, 2], found[n, 3] = q
        found[n, 4], found[n, 5], found[n, 6] = w


run_compiled = kernel(run)
visit_compiled = kernel(visit)
