"""Rotation matrices of shape (…, 3, 3): about axes (thesis 2.2.2), to and from quaternions (2.2.5)."""

from __future__ import annotations

from functools import reduce
from operator import add

from rotation.angles import waves
from rotation.array_types import Array, ArrayLike, Namespace
from rotation.coordinates import Coordinates, join, split, unit
from rotation.namespaces import expect_last, finfo, floats, namespace, quiet, refuse_rows
from rotation.optimum import davenport, with_derivatives, without_derivatives
from rotation.rowwise import RowFormula, flag_if, rarely

# The largest difference of an entry of RᵀR from 1 in a matrix that is accepted as a rotation.
TOLERANCE = {64: 1e-6, 32: 1e-3}  # by the bits of a float

# What to add to a number of at most 1 and take away again, to round it to a multiple of 2⁻²⁶ or 2⁻¹¹.
_GRID = {64: 1.5 * 2.0**26, 32: 1.5 * 2.0**12}

Entries = list[list[Array]]


def R_x(angle: ArrayLike, degrees: bool = False) -> Array:
    """Return the matrices (…, 3, 3) of rotations by ``angle`` (…) about x (thesis, section 2.2.2).

    Examples
    --------
    >>> R_x(90, degrees=True).round(15) + 0.0
    array([[ 1.,  0.,  0.],
           [ 0.,  0., -1.],
           [ 0.,  1.,  0.]])
    """
    return _about(0, angle, degrees)


def R_y(angle: ArrayLike, degrees: bool = False) -> Array:
    """Return the matrices (…, 3, 3) of rotations by ``angle`` (…) about y (thesis, section 2.2.2).

    Examples
    --------
    >>> R_y(90, degrees=True).round(15) + 0.0
    array([[ 0.,  0.,  1.],
           [ 0.,  1.,  0.],
           [-1.,  0.,  0.]])
    """
    return _about(1, angle, degrees)


def R_z(angle: ArrayLike, degrees: bool = False) -> Array:
    """Return the matrices (…, 3, 3) of rotations by ``angle`` (…) about z (thesis, section 2.2.2).

    Examples
    --------
    >>> R_z(90, degrees=True).round(15)
    array([[ 0., -1.,  0.],
           [ 1.,  0.,  0.],
           [ 0.,  0.,  1.]])
    """
    return _about(2, angle, degrees)


@quiet
def _about(axis: int, angle: ArrayLike, degrees: bool) -> Array:
    a = floats(angle, "angles")
    xp = namespace(a)
    (s, c), zero = waves(xp, a, degrees), 0.0 * xp.abs(a)  # NaN fills the whole matrix
    entries = [[zero] * 3 for _ in range(3)]
    j, k = (axis + 1) % 3, (axis + 2) % 3  # the plane that turns, from j towards k
    entries[axis][axis] = 1.0 + zero
    entries[j][j], entries[j][k] = c, -s
    entries[k][j], entries[k][k] = s, c
    return _assemble(xp, entries)


def _assemble(xp: Namespace, entries: Entries) -> Array:
    return xp.stack([xp.stack(row, axis=-1) for row in entries], axis=-2)


def _entries(m: Array) -> Entries:
    return [[m[..., r, c] for c in range(3)] for r in range(3)]


def to_matrix(q: Array) -> Array:
    """Return the matrices (…, 3, 3) of quaternions (…, 4) whose norm is 1 up to rounding.

    N(q) is computed with twice the digits, and its deviation from 1 is corrected in each entry. Entries are
    accurate to 2·2⁻⁵² (docs/explanation/rotation-errors.md proves it), and the matrix is orthogonal.
    """
    return TO_MATRIX(q)


def _to_matrix(q: Array) -> Array:
    return _assemble(namespace(q), matrix_entries(split(q)))


def matrix_entries(c: Coordinates) -> Entries:
    """Return the entries of the matrices of `to_matrix`, row by row, from the coordinates of quaternions."""
    xp = namespace(c[0])
    # Upper halves on a grid so coarse that their squares and sums are exact; the remainders are
    # small.
    grid = _GRID[finfo(xp, c[0]).bits]
    upper = [(a + grid) - grid for a in c]
    ww, xx, yy, zz = (h * h for h in upper)
    fma = getattr(xp, "fma", None)
    if fma is None:
        we, xe, ye, ze = ((a - h) * (a + h) for a, h in zip(c, upper, strict=True))
    else:
        we, xe, ye, ze = (fma(a, a, -h) for a, h in zip(c, (ww, xx, yy, zz), strict=True))
    wx, yz, wx_low, yz_low = ww + xx, yy + zz, we + xe, ye + ze
    off = ((wx + yz) - 1.0) + (wx_low + yz_low)  # N(q) − 1

    def plus(a: Array, b: Array, rest: Array) -> Array:
        return a * b + rest if fma is None else fma(a, b, rest)

    def cosine(high: Array, low: Array) -> Array:
        return high + plus(-high, off, low)

    def sine(a: Array, b: Array, other: Array) -> Array:
        rough = plus(a, b, other)
        return plus(-rough, off, rough)

    w, x, y, z = c
    x2, y2 = x + x, y + y
    wz, wy, wx2 = (w + w) * z, (w + w) * y, (w + w) * x
    return [
        [cosine(wx - yz, wx_low - yz_low), sine(x2, y, -wz), sine(x2, z, wy)],
        [sine(x2, y, wz), cosine((ww - xx) + (yy - zz), (we - xe) + (ye - ze)), sine(y2, z, -wx2)],
        [sine(x2, z, -wy), sine(y2, z, wx2), cosine((ww - xx) - (yy - zz), (we - xe) - (ye - ze))],
    ]


TO_MATRIX = RowFormula(_to_matrix, (4,))


def from_matrix(matrix: ArrayLike, orthonormalize: bool = False) -> Array:
    """Return the unit quaternions (…, 4) of rotation matrices (…, 3, 3).

    Matrices that are orthogonal only up to rounding are first replaced by the nearest rotation.

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
        m = scaled(xp, m)
    else:
        q, faulty = _FROM_MATRIX[tolerance].with_flag(m)
        if not faulty:
            return q
    faults = _FAULTS(m)
    refuse_rows(
        faults[..., 0] < 0.0,
        "the matrix",
        "is a reflection (its determinant is negative), not a rotation",
    )
    if orthonormalize:
        q = _FROM_MATRIX[tolerance](_nearest(xp, without_derivatives(m)))
        return with_derivatives(q, davenport(_entries(m)))
    refuse_rows(
        faults[..., 1] > tolerance,
        "the matrix",
        f"is not orthogonal to within {tolerance:g}; orthonormalize=True takes the nearest rotation",
    )
    return q


def _from_matrix(m: Array, tolerance: float) -> Array:
    xp = namespace(m)
    r = _entries(m)
    flag_if(xp, (_determinant(r) < 0.0) | (_off(xp, r) > tolerance))
    r = _polished(xp, r)
    finite = xp.all(xp.isfinite(m), axis=(-2, -1))
    q = unit(xp, _dominant_row(xp, r))
    nan = xp.nan * xp.ones_like(q[0])
    return join(xp, tuple(xp.where(finite, c, nan) for c in q))


_FROM_MATRIX = {
    tolerance: RowFormula(_from_matrix, (3, 3), parameters=(tolerance,))
    for tolerance in TOLERANCE.values()
}


@quiet
def from_columns(numbers: ArrayLike) -> Array:
    """Return the unit quaternions of pairs of columns (…, 6), orthonormalised by Gram–Schmidt."""
    c = floats(numbers, "pairs of columns")
    expect_last(c, (6,), "pairs of columns")
    xp = namespace(c)
    a, b = unit(xp, split(c[..., :3])), unit(xp, split(c[..., 3:]))
    refuse_rows(xp.all(c[..., :3] == 0.0, axis=-1), "the first column", "is zero")
    along = reduce(add, (x * y for x, y in zip(a, b, strict=True)))
    rest = tuple(y - along * x for x, y in zip(a, b, strict=True))
    size = reduce(add, (x * x for x in rest))
    parallel = (size <= (16.0 * float(xp.finfo(c.dtype).eps)) ** 2) | xp.all(
        c[..., 3:] == 0.0, axis=-1
    )
    refuse_rows(parallel, "the second column", "is a multiple of the first")
    b = unit(xp, rest)
    again = reduce(add, (x * y for x, y in zip(a, b, strict=True)))
    b = unit(xp, tuple(y - again * x for x, y in zip(a, b, strict=True)))
    (p, q, r), (s, t, u) = a, b
    third = (q * u - r * t, r * s - p * u, p * t - q * s)
    rows = [join(xp, row) for row in zip(a, b, third, strict=True)]
    return from_matrix(xp.stack(rows, axis=-2))


def _bits(matrix: ArrayLike, xp: Namespace) -> int:
    """Return 32 for single precision, and 64 for every other type in which a matrix may be given."""
    return 32 if getattr(matrix, "dtype", None) == xp.float32 else 64


@quiet
def scaled(xp: Namespace, m: Array) -> Array:
    """Return matrices scaled to largest entry 1, so that products of entries neither overflow nor
    underflow.
    """
    return m / largest(xp, m)


def largest(xp: Namespace, m: Array) -> Array:
    """Return the largest absolute entries of matrices, shape (…, 1, 1); 1 for zero matrices."""
    found = xp.max(xp.abs(m), axis=(-2, -1), keepdims=True)
    return xp.where(found > 0.0, found, xp.ones_like(found))


def _faults(m: Array) -> Array:
    """Return the determinant, and the deviation of ``RᵀR`` from 1; both NaN unless all entries are finite."""
    r = _entries(m)
    determinant = _determinant(r)
    xp = namespace(m)
    finite = xp.all(xp.isfinite(m), axis=(-2, -1))
    return join(xp, tuple(xp.where(finite, x, xp.nan * x) for x in (determinant, _off(xp, r))))


_FAULTS = RowFormula(_faults, (3, 3))


def _determinant(r: Entries) -> Array:
    (a, b, c), (d, e, f), (g, h, i) = r
    found: Array = a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)
    return found


def _gram(r: Entries) -> tuple[Array, ...]:
    """Return the entries of the symmetric ``RᵀR``: (0,0), (1,1), (2,2), (0,1), (0,2), (1,2)."""
    columns = list(zip(*r, strict=True))
    pairs = ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))
    return tuple(
        reduce(add, (x * y for x, y in zip(columns[p], columns[q], strict=True))) for p, q in pairs
    )


def _off(xp: Namespace, r: Entries) -> Array:
    """Return the largest entry of ``|RᵀR − 1|``."""
    g = _gram(r)
    errors = [*(xp.abs(x - 1.0) for x in g[:3]), *(xp.abs(x) for x in g[3:])]
    return reduce(xp.maximum, errors)


def _polished(xp: Namespace, r: Entries) -> Entries:
    """Return the orthogonal matrices nearest to nearly orthogonal ones, by Newton–Schulz steps, row
    by row.
    """
    rough = _off(xp, r) > 8.0 * float(finfo(xp, r[0][0]).eps)

    def steps() -> tuple[Array, ...]:
        better = r
        for _ in range(3):  # 1e-3 → 1e-6 → 1e-12 → exact
            better = _newton(better)
        return tuple(
            xp.where(rough, x, y)
            for row, old in zip(better, r, strict=True)
            for x, y in zip(row, old, strict=True)
        )

    flat = rarely(xp, rough, steps, tuple(x for row in r for x in row))
    return [list(flat[n : n + 3]) for n in (0, 3, 6)]


def _newton(r: Entries) -> Entries:
    xx, yy, zz, xy, xz, yz = _gram(r)
    gram = ((xx, xy, xz), (xy, yy, yz), (xz, yz, zz))
    return [
        [
            1.5 * x - 0.5 * reduce(add, (p * q for p, q in zip(row, c, strict=True)))
            for x, c in zip(row, gram, strict=True)
        ]
        for row in r
    ]


@quiet
def _nearest(xp: Namespace, m: Array) -> Array:
    """Return the orthogonal polar factor of matrices of nonnegative determinant; NaN rows stay NaN."""
    finite = xp.all(xp.isfinite(m), axis=(-2, -1))[..., None, None]
    u, s, vt = xp.linalg.svd(xp.where(finite, m, xp.eye(3, dtype=m.dtype)))
    refuse_rows(
        s[..., 2] <= 8.0 * float(xp.finfo(m.dtype).eps) * s[..., 0],
        "the matrix",
        "is singular, so no rotation is the nearest to it",
    )
    return xp.where(finite, xp.matmul(u, vt), m)


def _proper(u: Array, s: Array, vt: Array) -> Array:
    """Return u with s below it, for matrices ``u·s·vt``, with signs such that ``u·vt`` is a rotation."""
    xp = namespace(u)
    rows = _proper_rows(xp, _entries(u), split(s), _entries(vt))
    return xp.stack([join(xp, row) for row in rows], axis=-2)


def _proper_rows(xp: Namespace, u: Entries, s: Coordinates, vt: Entries) -> list[Coordinates]:
    mirrored = _determinant(u) * _determinant(vt) < 0.0
    return [(a, b, xp.where(mirrored, -c, c)) for a, b, c in (*u, s)]


PROPER = RowFormula(_proper, (3, 3), (3,), (3, 3))


def _nearest_to_svd(u: Array, s: Array, vt: Array) -> Array:
    """Return the quaternion of the rotation nearest to ``u·s·vt``.

    The row is flagged if the nearest rotation is not unique up to rounding, or if a sum may have lost small
    terms.
    """
    xp = namespace(u)
    v = _entries(vt)
    *rows, (first, second, third) = _proper_rows(xp, _entries(u), split(s), v)
    tiny = 16.0 * float(finfo(xp, first).eps) * first
    flag_if(xp, (second <= tiny) | (second + third <= tiny) | (first < 1e-200) | (first > 1e200))
    r = [
        [reduce(add, (x * w[n] for x, w in zip(row, v, strict=True))) for n in range(3)]
        for row in rows
    ]
    return join(xp, unit(xp, _dominant_row(xp, _polished(xp, r))))


NEAREST_TO_SVD = RowFormula(_nearest_to_svd, (3, 3), (3,), (3, 3))


def _dominant_row(xp: Namespace, r: Entries) -> Coordinates:
    """Return a multiple of q: the row of ``4·q·qᵀ`` with the largest diagonal entry.

    S. W. Shepperd, "Quaternion from rotation matrix", J. Guidance and Control 1 (1978).
    """
    rows = [list(row) for row in davenport(r)]
    for n, row in enumerate(rows):
        row[n] = 1.0 + row[n]
    best, largest = tuple(rows[0]), rows[0][0]
    for n, row in enumerate(rows[1:], 1):
        entry = row[n]
        better = entry > largest
        best = tuple(xp.where(better, x, y) for x, y in zip(row, best, strict=True))
        largest = xp.where(better, entry, largest)
    return best
