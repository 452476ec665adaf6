"""Find and count the roots in M₂(F) of a polynomial of norm 0, by trace and norm, and by one of its rows.

A polynomial with matrices as coefficients is a matrix of polynomials, and its norm is the determinant. If the
norm is 0 and the polynomial is not, the polynomial is a column without common factor times a row w, and q is
a root if Σ wₙ·qⁿ = 0. Modulo x² − t·x + n the row is a + b·x. If a and b are independent, the q with b·q = −a
and a·q = t·a + n·b is the only root of trace t and norm n.
"""

from __future__ import annotations

from collections.abc import Hashable, Iterable, Iterator, Sequence
from itertools import islice, product

from hfield.core.product import Scalar
from hfield.errors import TooLargeError
from hfield.fields.base.ring import Ring
from hfield.fields.base.roots import (
    added,
    common_divisor,
    divided,
    multiplied,
    quadratic_divisors,
    stripped,
)

MAX_COMBINATIONS = 20_000

Row = list[list[Scalar]]
Matrix = tuple[tuple[Scalar, Scalar], tuple[Scalar, Scalar]]


def other_root(
    F: Ring, f: Sequence[Matrix], spheres: Sequence[tuple[Scalar, Scalar]]
) -> Matrix | None:
    """Return a root whose trace and norm are not among ``spheres``, or None."""
    content, primitive = _row(F, f)
    if all(len(entry) < 2 for entry in primitive):
        v = [(*entry, F.zero)[0] for entry in primitive]
        return _with_a_left_eigenvector(F, content, v, spheres)
    w = [multiplied(F, entry, content) for entry in primitive]
    enough = _traces_and_norms(F, 2 * max(map(len, w)))
    return next(_roots_at(F, w, spheres, enough, every=False), None)


def other_roots(
    F: Ring, f: Sequence[Matrix], spheres: Sequence[tuple[Scalar, Scalar]]
) -> Iterator[Matrix]:
    """Yield all roots outside the given spheres, over a finite field."""
    content, primitive = _row(F, f)
    w = [multiplied(F, entry, content) for entry in primitive]
    yield from _roots_at(F, w, spheres, product(F.elements(), repeat=2), every=True)


def count_other_roots(F: Ring, f: Sequence[Matrix]) -> int:
    """Return the number of these roots over a finite field.

    Modulo x² − t·x + n the row is a + b·x. There is one root if a and b are independent, that is, if x² − t·x
    + n divides no combination of the entries. Each root r of the content gives q matrices for every (x −
    r)·(x − s) that does not divide it.

    Raises :class:`TooLargeError` over a field of more than ``MAX_COMBINATIONS`` elements.
    """
    q = F.order
    assert q is not None, "the field is finite"
    content, (u, v) = _row(F, f)
    roots = [-g[0] for g in F.irreducible_factors(content) if len(g) == 2]
    divisors = _keys(F, quadratic_divisors(F, content))
    total = q * sum(q - sum((F.key(r + s), F.key(r * s)) in divisors for s in roots) for r in roots)
    if max(len(u), len(v)) < 2:
        return int(total)
    if q > MAX_COMBINATIONS:
        raise TooLargeError(
            f"roots of a polynomial of norm 0 are counted over at most {MAX_COMBINATIONS} elements, and "
            f"{F.name} has more"
        )
    dependent = _keys(F, quadratic_divisors(F, multiplied(F, content, v))) if v else set()
    for c in F.elements():
        combined = added(F, u, [c * x for x in v])
        dependent |= _keys(F, quadratic_divisors(F, multiplied(F, content, combined)))
    return int(total + q * q - len(dependent))


def _keys(F: Ring, pairs: Iterator[tuple[Scalar, Scalar]]) -> set[tuple[Hashable, Hashable]]:
    return {(F.key(t), F.key(n)) for t, n in pairs}


def _row(F: Ring, f: Sequence[Matrix]) -> tuple[list[Scalar], Row]:
    """Return polynomials c and w₁, w₂ without common divisor such that f has the roots of c·(w₁, w₂)."""
    rows = [[[c[r][s] for c in f] for s in (0, 1)] for r in (0, 1)]
    row = next(row for row in rows if any(not F.is_zero(c) for entry in row for c in entry))
    divisor = common_divisor(F, *row)
    content: list[Scalar] = []
    for entry in (*rows[0], *rows[1]):
        content = common_divisor(F, content, entry)
    return content, [stripped(F, divided(F, entry, divisor)[0]) for entry in row]


def _roots_at(
    F: Ring,
    w: Row,
    spheres: Sequence[tuple[Scalar, Scalar]],
    places: Iterable[tuple[Scalar, Scalar]],
    every: bool,
) -> Iterator[Matrix]:
    """Yield roots with given traces and norms outside the spheres: one for each pair, or all of them with
    ``every``.
    """
    known = {(F.key(t), F.key(n)) for t, n in spheres}
    for t, n in places:
        if (F.key(t), F.key(n)) in known:
            continue
        a, b = zip(*(_reduced(F, entry, t, n) for entry in w), strict=True)
        det = a[0] * b[1] - a[1] * b[0]
        if not F.is_zero(det):
            # rows b, a; in their basis q is ((0, −1), (n, t))
            yield _in_basis(F, b, a, ((F.zero, -F.one), (n, t)))
            continue
        at = next((s for s in (0, 1) if not F.is_zero(b[s])), None)
        if at is not None:  # b·q = r·b
            r = -F.divide(a[at], b[at])
            if F.is_zero(r * r - t * r + n):
                for x in F.elements() if every else (F.zero,):
                    yield _with_eigenvector(F, b, r, t - r, x)


def _with_a_left_eigenvector(
    F: Ring, g: list[Scalar], v: list[Scalar], spheres: Sequence[tuple[Scalar, Scalar]]
) -> Matrix | None:
    """Return a q outside the spheres with v·g(q) = 0, where v is an eigenvector of q for a root of g; or
    None.
    """
    for factor in F.irreducible_factors(g):
        if len(factor) == 2:
            r = -factor[0]
            for s in _elements(F, len(spheres) + 1):
                if not any(F.equal(n, r * s) and F.equal(t, r + s) for t, n in spheres):
                    return _with_eigenvector(F, v, r, s, F.zero)
    return None


def _with_eigenvector(F: Ring, v: Sequence[Scalar], r: Scalar, s: Scalar, x: Scalar) -> Matrix:
    """Return a matrix with v·q = r·v and u·q = x·v + s·u, for some u."""
    other = (F.zero, F.one) if not F.is_zero(v[0]) else (F.one, F.zero)
    return _in_basis(F, v, other, ((r, F.zero), (x, s)))


def _in_basis(F: Ring, u: Sequence[Scalar], v: Sequence[Scalar], m: Matrix) -> Matrix:
    """Return the q with u·q = m₀₀·u + m₀₁·v and v·q = m₁₀·u + m₁₁·v."""
    back = F.inverse(u[0] * v[1] - u[1] * v[0])
    inverse = ((v[1] * back, -u[1] * back), (-v[0] * back, u[0] * back))
    images = [[m[r][0] * u[s] + m[r][1] * v[s] for s in (0, 1)] for r in (0, 1)]
    rows = [
        tuple(inverse[r][0] * images[0][s] + inverse[r][1] * images[1][s] for s in (0, 1))
        for r in (0, 1)
    ]
    return rows[0], rows[1]


def _traces_and_norms(F: Ring, size: int) -> Iterator[tuple[Scalar, Scalar]]:
    """Yield enough pairs (t, n): det(a, b) is a nonzero polynomial in t and n of degrees below ``size``."""
    elements = list(_elements(F, size))
    return product(elements, elements)


def _elements(F: Ring, count: int) -> Iterator[Scalar]:
    """Yield ``count`` elements, or all if there are fewer."""
    if not F.characteristic or F.characteristic >= count:
        yield from map(F, range(count))
    elif F.order is None:
        yield from (F.gen**n for n in range(count))
    else:
        yield from islice(F.elements(), count)


def _reduced(F: Ring, f: list[Scalar], t: Scalar, n: Scalar) -> tuple[Scalar, Scalar]:
    rest = [*divided(F, f, [n, -t, F.one])[1], F.zero, F.zero]
    return rest[0], rest[1]
