"""Rotation matrices of shape (…, 3, 3): the axes (thesis 2.2.2), to and from quaternions (2.2.5)."""

from functools import reduce
from operator import add
from typing import Any

from rotation import kernels
from rotation.angles import radians
from rotation.compensated import total, two_product
from rotation.coordinates import Coordinates, join, split, unit
from rotation.namespaces import (
    Array,
    expect_last,
    finfo,
    floats,
    is_numpy,
    namespace,
    quiet,
    refuse_rows,
)
from rotation.rowwise import MANY, in_pieces

# How far RᵀR may be from 1, entry by entry, in a matrix that is taken for a rotation.
TOLERANCE = {64: 1e-6, 32: 1e-3}  # by the bits of a float

Entries = list[list[Array]]


def R_x(angle: Any, degrees: bool = False) -> Array:
    """Return the matrices (…, 3, 3) that turn by ``angle`` (…) about x (thesis, section 2.2.2)."""
    return _about(0, angle, degrees)


def R_y(angle: Any, degrees: bool = False) -> Array:
    """Return the matrices (…, 3, 3) that turn by ``angle`` (…) about y (thesis, section 2.2.2)."""
    return _about(1, angle, degrees)


def R_z(angle: Any, degrees: bool = False) -> Array:
    """Return the matrices (…, 3, 3) that turn by ``angle`` (…) about z (thesis, section 2.2.2).

    Examples
    --------
    >>> R_z(90, degrees=True).round(15)
    array([[ 0., -1.,  0.],
           [ 1.,  0.,  0.],
           [ 0.,  0.,  1.]])
    """
    return _about(2, angle, degrees)


@quiet
def _about(axis: int, angle: Any, degrees: bool) -> Array:
    a = floats(angle, "angles")
    xp = namespace(a)
    a = radians(xp, a) if degrees else a
    c, s, zero = xp.cos(a), xp.sin(a), 0.0 * xp.abs(a)  # NaN in the whole matrix where it is
    entries = [[zero] * 3 for _ in range(3)]
    j, k = (axis + 1) % 3, (axis + 2) % 3  # the plane that turns, from j towards k
    entries[axis][axis] = 1.0 + zero
    entries[j][j], entries[j][k] = c, -s
    entries[k][j], entries[k][k] = s, c
    return _assemble(xp, entries)


def _assemble(xp: Any, entries: Entries) -> Array:
    return xp.stack([xp.stack(row, axis=-1) for row in entries], axis=-2)


def _entries(m: Array) -> Entries:
    return [[m[..., r, c] for c in range(3)] for r in range(3)]


def to_matrix(q: Array) -> Array:
    """Return the matrices (…, 3, 3) of quaternions (…, 4) whose norm is 1, or off by rounding.

    N(q) is computed with twice the digits, and how far it is from 1 is taken off each entry: an entry is
    right to 2⁻⁵², and the matrix orthogonal.
    """
    if is_numpy(namespace(q)) and q.size > 4 * MANY:
        m, left = kernels.matrices(q)
        if not left:
            return m
    return in_pieces(_to_matrix, q)


def _to_matrix(q: Array) -> Array:
    xp = namespace(q)
    w, x, y, z = split(q)
    (ww, we), (xx, xe), (yy, ye), (zz, ze) = (two_product(xp, c, c) for c in (w, x, y, z))
    high, low = total([(ww, we), (xx, xe), (yy, ye), (zz, ze)])
    more = ((1.0 - high) - low) / high  # 1/N(q) − 1

    def entry(half: Array) -> Array:
        return 2.0 * half + (2.0 * half) * more

    def cosine(plus: Array, minus: Array) -> Array:
        """Plus less minus, by the smaller of them: it loses less."""
        return xp.where(minus < plus, 1.0 - entry(minus), entry(plus) - 1.0)

    wx, yz = (ww + xx) + (we + xe), (yy + zz) + (ye + ze)
    wy, xz = (ww + yy) + (we + ye), (xx + zz) + (xe + ze)
    wz, xy = (ww + zz) + (we + ze), (xx + yy) + (xe + ye)
    return _assemble(
        xp,
        [
            [cosine(wx, yz), entry(x * y - w * z), entry(x * z + w * y)],
            [entry(x * y + w * z), cosine(wy, xz), entry(y * z - w * x)],
            [entry(x * z - w * y), entry(y * z + w * x), cosine(wz, xy)],
        ],
    )


@quiet
def from_matrix(matrix: Any, orthonormalize: bool = False) -> Array:
    """Return the unit quaternions (…, 4) of rotation matrices (…, 3, 3).

    What is off orthogonal by rounding is replaced by the nearest rotation first.

    Parameters
    ----------
    matrix : array_like, shape (…, 3, 3)
    orthonormalize : bool
        Accept every matrix of positive determinant and take the rotation nearest to it in the
        Frobenius norm (the orthogonal factor of its polar decomposition).

    Raises
    ------
    RotationError
        The determinant is negative; or RᵀR differs from 1 by more than 1e-6 (1e-3 for float32)
        and ``orthonormalize`` is false; or the matrix is singular.
    """
    m = floats(matrix, "matrices")
    expect_last(m, (3, 3), "matrices")
    xp = namespace(m)
    tolerance = TOLERANCE[_bits(matrix, xp)]
    if orthonormalize:
        m = _scaled(xp, m)
    faults = in_pieces(_faults, m, rank=2)
    refuse_rows(
        faults[..., 0] < 0.0,
        "the matrix",
        "is a reflection (its determinant is negative), not a rotation",
    )
    if orthonormalize:
        m = _nearest(xp, m)
    else:
        refuse_rows(
            faults[..., 1] > tolerance,
            "the matrix",
            f"is not orthogonal to within {tolerance:g}; orthonormalize=True takes the nearest rotation",
        )
    return in_pieces(_from_matrix, m, rank=2)


def _from_matrix(m: Array) -> Array:
    xp = namespace(m)
    r = _polished(xp, _entries(m))
    finite = xp.all(xp.isfinite(m), axis=(-2, -1))
    q = unit(xp, _dominant_row(xp, r))
    return join(xp, tuple(xp.where(finite, c, xp.nan * c) for c in q))


def _bits(matrix: Any, xp: Any) -> int:
    """32 for single precision, 64 for everything else that a matrix may be given as."""
    return 32 if getattr(matrix, "dtype", None) == xp.float32 else 64


def _scaled(xp: Any, m: Array) -> Array:
    """Matrices whose largest entry is 1, so that no determinant over- or underflows."""
    largest = xp.max(xp.abs(m), axis=(-2, -1), keepdims=True)
    return m / xp.where(largest > 0.0, largest, xp.ones_like(largest))


def _faults(m: Array) -> Array:
    """The determinant, and how far ``RᵀR`` is from 1; both NaN unless all entries are finite."""
    r = _entries(m)
    (a, b, c), (d, e, f), (g, h, i) = r
    determinant = a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)
    xp = namespace(m)
    finite = xp.all(xp.isfinite(m), axis=(-2, -1))
    return join(xp, tuple(xp.where(finite, x, xp.nan * x) for x in (determinant, _off(xp, r))))


def _gram(r: Entries) -> tuple[Array, ...]:
    """The entries of the symmetric ``RᵀR``: (0,0), (1,1), (2,2), (0,1), (0,2), (1,2)."""
    columns = list(zip(*r, strict=True))
    pairs = ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))
    return tuple(
        reduce(add, (x * y for x, y in zip(columns[p], columns[q], strict=True))) for p, q in pairs
    )


def _off(xp: Any, r: Entries) -> Array:
    """The largest entry of ``|RᵀR − 1|``."""
    g = _gram(r)
    errors = [*(xp.abs(x - 1.0) for x in g[:3]), *(xp.abs(x) for x in g[3:])]
    return reduce(xp.maximum, errors)


def _polished(xp: Any, r: Entries) -> Entries:
    """The nearest orthogonal matrices to nearly orthogonal ones, by Newton and Schulz, row by row."""
    rough = _off(xp, r) > 8.0 * float(finfo(xp, r[0][0]).eps)
    for _ in range(3):  # 1e-3 → 1e-6 → 1e-12 → exact
        if not bool(xp.any(rough)):
            break
        xx, yy, zz, xy, xz, yz = _gram(r)
        gram = ((xx, xy, xz), (xy, yy, yz), (xz, yz, zz))
        r = [
            [
                xp.where(
                    rough,
                    1.5 * x - 0.5 * reduce(add, (p * q for p, q in zip(row, c, strict=True))),
                    x,
                )
                for x, c in zip(row, gram, strict=True)
            ]
            for row in r
        ]
    return r


def _nearest(xp: Any, m: Array) -> Array:
    """The orthogonal polar factor of matrices of nonnegative determinant; NaN rows stay."""
    finite = xp.all(xp.isfinite(m), axis=(-2, -1))[..., None, None]
    u, s, vt = xp.linalg.svd(xp.where(finite, m, xp.eye(3, dtype=m.dtype)))
    refuse_rows(
        s[..., 2] <= 8.0 * float(xp.finfo(m.dtype).eps) * s[..., 0],
        "the matrix",
        "is singular, so no rotation is the nearest to it",
    )
    return xp.where(finite, xp.matmul(u, vt), m)


def _dominant_row(xp: Any, r: Entries) -> Coordinates:
    """A multiple of q: of the four rows of ``4·q·qᵀ`` the one with the largest diagonal entry.

    S. W. Shepperd, "Quaternion from rotation matrix", J. Guidance and Control 1 (1978).
    """
    (a, b, c), (d, e, f), (g, h, i) = r
    diagonal = (1.0 + a + e + i, 1.0 + a - e - i, 1.0 - a + e - i, 1.0 - a - e + i)
    wx, wy, wz = h - f, c - g, d - b
    xy, xz, yz = b + d, c + g, f + h
    rows = (
        (diagonal[0], wx, wy, wz),
        (wx, diagonal[1], xy, xz),
        (wy, xy, diagonal[2], yz),
        (wz, xz, yz, diagonal[3]),
    )
    best, largest = rows[0], diagonal[0]
    for row, entry in zip(rows[1:], diagonal[1:], strict=True):
        better = entry > largest
        best = tuple(xp.where(better, x, y) for x, y in zip(row, best, strict=True))
        largest = xp.where(better, entry, largest)
    return best
