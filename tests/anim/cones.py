"""What the top looks like by another road: rays through the pixels, met with three cones. No polygons.

Nothing here is shared with the painters but the projection matrix, which is inverted.
"""

from itertools import pairwise

import numpy as np

NOTHING = -1
BACK = 3.5
"""How far before the origin rays start: outside of the top, behind no eye."""


def rays(matrix, x, y):
    """Return origins and directions (k, 3) of the rays through pixels (x, y), y upwards."""
    cube = np.array([[i, j, k, 1] for i in (-1, 1) for j in (-1, 1) for k in (-1, 1)]) @ matrix.T
    depths = cube[:, 2] / cube[:, 3]
    inverse = np.linalg.inv(matrix)
    ends = []
    for depth in (depths.max(), depths.min()):
        pixels = [x, y, np.full(x.size, depth), np.ones(x.size)]
        points = np.column_stack(pixels) @ inverse.T
        ends.append(points[:, :3] / points[:, 3:])
    direction = ends[1] - ends[0]
    direction /= np.linalg.norm(direction, axis=1)[:, None]
    return ends[0] - BACK * direction, direction


def cone_hits(origin, direction, low, high, least=-np.inf):
    """Return the distances, above ``least``, to a cone of revolution between two rims (r, z); inf: none."""
    (r0, z0), (r1, z1) = low, high
    if z0 == z1:
        with np.errstate(invalid="ignore", divide="ignore"):
            t = (z0 - origin[:, 2]) / direction[:, 2]
            radius = np.hypot(*(origin[:, :2] + t[:, None] * direction[:, :2]).T)
        met = (radius >= min(r0, r1)) & (radius <= max(r0, r1)) & (t > least)
        return np.where(met, t, np.inf)
    slope = (r1 - r0) / (z1 - z0)
    base = r0 - slope * z0
    ox, oy, oz = origin.T
    dx, dy, dz = direction.T
    radius, change = base + slope * oz, slope * dz
    a = dx * dx + dy * dy - change * change
    b = ox * dx + oy * dy - radius * change
    c = ox * ox + oy * oy - radius * radius
    with np.errstate(invalid="ignore", divide="ignore"):
        root = np.sqrt(b * b - a * c)
        best = np.full(len(origin), np.inf)
        for t in ((-b - root) / a, (-b + root) / a):
            z = oz + t * dz
            good = (z >= z0) & (z <= z1) & (t > least)
            best = np.where(good & (t < best), t, best)
    return best


def reference(matrix, size, rotation, model):
    """Return what each pixel shows, (h, w): NOTHING, or 2·piece + colour of the band."""
    width, height = size
    x, y = np.meshgrid(np.arange(width) + 0.5, height - 0.5 - np.arange(height))
    near = near_the_top(matrix, rotation, model, x, y)
    origin, direction = rays(matrix, x[near], y[near])
    origin, direction = origin @ rotation, direction @ rotation
    profile = model.profile
    times = np.array([cone_hits(origin, direction, a, b) for a, b in pairwise(profile)])
    piece = times.argmin(axis=0)
    t = times.min(axis=0)
    hit = np.isfinite(t)
    point = origin + np.where(hit, t, 0)[:, None] * direction
    turn = np.arctan2(point[:, 1], point[:, 0]) / (2 * np.pi) % 1
    face = np.minimum((turn * model.ring).astype(int), model.ring - 1)
    shown = np.full(x.shape, NOTHING)
    shown[near] = np.where(hit, 2 * piece + model.sectors[face] % 2, NOTHING)
    return shown


def near_the_top(matrix, rotation, model, x, y):
    """Tell which pixels lie in the rectangle round the projected points, where rays are worth sending."""
    places = np.column_stack([model.points @ rotation.T, np.ones(len(model.points))]) @ matrix.T
    u, v = places[:, 0] / places[:, 3], places[:, 1] / places[:, 3]
    return (x > u.min() - 3) & (x < u.max() + 3) & (y > v.min() - 3) & (y < v.max() + 3)


def interior(shown):
    """Tell which pixels have a uniform neighbourhood of 3 × 3."""
    height, width = shown.shape
    middle = shown[1:-1, 1:-1]
    same = np.ones(middle.shape, bool)
    for y in range(3):
        for x in range(3):
            same &= middle == shown[y : y + height - 2, x : x + width - 2]
    return np.pad(same, 1)


def nearest(picture, colours):
    """Return the index of the colour (k, 3) nearest to each pixel."""
    apart = picture[..., None, :].astype(int) - np.asarray(colours)
    return (apart**2).sum(axis=-1).argmin(axis=-1)


def random_rotation(rng):
    """Return a rotation drawn from the uniform distribution (QR of a normal matrix)."""
    q, r = np.linalg.qr(rng.normal(size=(3, 3)))
    q *= np.sign(np.diag(r))
    return q if np.linalg.det(q) > 0 else -q
