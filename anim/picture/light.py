"""Where the light stands, and the shadow that the top throws on the ground."""

from math import cos, radians, sin

import numpy as np
from numpy.typing import NDArray

from anim.model import Model
from anim.picture.look import Camera, Look
from anim.picture.merge import HIDDEN, Rim, outlines
from anim.picture.mesh import Mesh
from anim.picture.projection import View, reached
from anim.picture.solid import Piece

Floats = NDArray[np.float64]

ASIDE, HEIGHT = -50.0, 58.0
"""Degrees: how far the light stands to the left of the camera, and how high above the ground."""


def direction(camera: Camera) -> Floats:
    """Return the unit vector (3,) towards the light, which is far away."""
    a, e = radians(camera.azimuth + ASIDE), radians(HEIGHT)
    return np.array([cos(e) * cos(a), cos(e) * sin(a), sin(e)])


def places(model: Model, look: Look) -> Floats:
    """Return points (k, 3) spread over all places of the top, and of its shadow if the look has one."""
    top = reached(model, look.tilt, look.room)
    if not look.shadow:
        return top
    above = top[top[:, 2] >= 0]
    return np.concatenate([top, above @ _fall(direction(look.camera))[:3, :3].T])


def _fall(light: Floats) -> Floats:
    """Return the map (4, 4) of homogeneous points along the light onto the ground."""
    fall = np.diag([1.0, 1.0, 0.0, 1.0])
    fall[:2, 2] = -light[:2] / light[2]
    return fall


def shadow(
    mesh: Mesh,
    parts: tuple[Piece, ...],
    rotation: Floats,
    place: Floats,
    light: Floats,
    view: View,
) -> list[Floats]:
    """Return the shadow on the plane z = 0 as loops of pixels, to be filled together (nonzero winding).

    Each convex piece throws the shadow of its faces turned to the light, one loop or two of the same
    sense, so that the loops of all pieces make up the whole shadow. What has sunk below the ground throws
    none.
    """
    here = mesh.points @ rotation.T + place
    source = np.append(light @ rotation, 0.0)
    on_ground = View(view.matrix @ _fall(light))
    loops: list[Floats] = []
    for part in parts:
        keys = np.where(part.facing(source), 0, HIDDEN)
        for _, rims in outlines(Rim(here[part.low]), Rim(here[part.high]), keys):
            above = [_above_ground(rim) for rim in rims]
            loops += [on_ground.project(rim) for rim in above if len(rim) > 2]
    return loops


def _above_ground(loop: Floats) -> Floats:
    """Return the part of a closed polygon (k, 3) with z ≥ 0 (Sutherland and Hodgman 1974)."""
    z = loop[:, 2]
    if z.min() >= 0:
        return loop
    following, z_next = np.roll(loop, -1, axis=0), np.roll(z, -1)
    crosses = (z >= 0) != (z_next >= 0)
    drop = np.where(crosses, z - z_next, 1.0)
    crossing = loop + (z / drop)[:, None] * (following - loop)
    both = np.stack([loop, crossing], axis=1).reshape(-1, 3)
    return np.asarray(both[np.column_stack([z >= 0, crosses]).ravel()])
