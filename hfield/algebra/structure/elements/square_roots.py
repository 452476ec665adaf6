"""Square roots of elements: at most four, or a whole quadric of them when the element is a scalar."""

from collections.abc import Iterator
from dataclasses import dataclass

from hfield.core.product import Constants, Coordinates, Scalar, multiply, norm, trace
from hfield.errors import UndecidedError
from hfield.fields.base.ring import Ring
from hfield.fields.quadratic_forms.global_field import global_field, known_field
from hfield.fields.quadratic_forms.isomorphisms.splitting import split
from hfield.fields.quadratic_forms.norm_forms.zero_norms import zero_norm
from hfield.fields.quadratic_forms.normal_forms import (
    NormalForm,
    basis_of,
    discriminant,
    normal_form,
)


@dataclass(frozen=True)
class RootCoordinates:
    """The square roots of an element: those in ``isolated``, and more if ``quadric`` is not None.

    In that case the element is a scalar s, ``quadric`` is one root of trace 0, and the roots are the
    isolated ones and all elements of trace 0 and norm −s.
    """

    isolated: tuple[Coordinates, ...]
    quadric: Coordinates | None = None

    def __bool__(self) -> bool:
        """Return whether there is a square root."""
        return bool(self.isolated) or self.quadric is not None


def square_roots(ring: Ring, c: Constants, q: Coordinates) -> RootCoordinates:
    """Return the square roots of an element, each verified by squaring. The ring must be a field.

    For a root x of trace T and norm n, ``T·x = q + n``, ``n² = N(q)`` and ``T² = tr(q) + 2n``. If q is not a
    scalar, T is not 0 and these equations give all roots. Raises :class:`UndecidedError` if the ring does not
    decide square roots, or whether an element of given trace and norm exists.
    """
    if not ring.is_field:
        raise UndecidedError(f"{ring.no_field}: square roots are found over fields only")
    if not ring.is_exact:
        raise UndecidedError(f"{ring.name} is inexact: square roots are found over exact fields")
    if all(ring.is_zero(x) for x in q[1:]):
        return _of_scalar(ring, c, q[0])
    found: list[Coordinates] = []
    for n in _both_roots(ring, norm(c, q)):
        for t in _both_roots(ring, trace(c, q) + n + n):
            if not ring.is_zero(t):
                scale = ring.inverse(t)
                w, x, y, z = q
                found.append((scale * (w + n), scale * x, scale * y, scale * z))
    for root in found:
        if not _squares_to(ring, c, root, q):
            raise AssertionError("a square root that was found does not square to the element")
    return RootCoordinates(tuple(found))


def _both_roots(ring: Ring, x: Scalar) -> list[Scalar]:
    """Return the square roots of a scalar: none, one or two."""
    root = ring.sqrt(x)
    if root is None:
        return []
    return [root] if ring.equal(root, ring.zero - root) else [root, ring.zero - root]


def _of_scalar(ring: Ring, c: Constants, s: Scalar) -> RootCoordinates:
    """Return the roots of s·e: scalars, and elements of trace 0 and norm −s."""
    o = ring.zero
    if ring.is_zero(s):
        nilpotent = nilpotent_element(ring, c)
        return RootCoordinates(((o, o, o, o),) if nilpotent is None else (), nilpotent)
    root: Coordinates | None
    scalars = _both_roots(ring, s)
    if ring.characteristic == 2 and scalars:
        (r,) = scalars  # other roots differ from it by elements with square 0
        nilpotent = nilpotent_element(ring, c)
        if nilpotent is None:
            return RootCoordinates(((r, o, o, o),))
        w, x, y, z = nilpotent
        scalars, root = [], (r + w, x, y, z)
    else:
        root = traceless_root(ring, c, s)
    if root is not None and not _squares_to(ring, c, root, (s, o, o, o)):
        raise AssertionError("a square root that was found does not square to the scalar")
    return RootCoordinates(tuple((r, o, o, o) for r in scalars), root)


def _squares_to(ring: Ring, c: Constants, root: Coordinates, q: Coordinates) -> bool:
    return all(ring.agree(x, y) for x, y in zip(multiply(c, root, root), q, strict=True))


def nilpotent_element(ring: Ring, c: Constants) -> Coordinates | None:
    """Return a nonzero element with square 0 over a field, or None in a division algebra."""
    _, i, j, _ = basis_of(ring)
    if ring.is_zero(c.b):
        return j
    if ring.is_zero(discriminant(ring, c)) and ring.characteristic != 2:
        return ring.zero - c.t, ring(2), ring.zero, ring.zero
    q = zero_norm(ring, c).element
    if q is None or ring.is_zero(trace(c, q)):
        return q
    # q·A is a plane of elements of norm 0, and the trace vanishes on a line in it
    t = trace(c, q)
    for u in (i, j):
        p = multiply(c, q, u)
        s = trace(c, p)
        w, x, y, z = (s * m - t * n for m, n in zip(q, p, strict=True))
        if not all(map(ring.is_zero, (w, x, y, z))):
            return w, x, y, z
    raise AssertionError("a zero divisor generates an ideal of dimension 2")


def traceless_root(ring: Ring, c: Constants, s: Scalar) -> Coordinates | None:
    """Return some x of trace 0 with ``x² = s``, s ≠ 0, or None if there is none."""
    if ring.characteristic == 2:
        return _traceless_root_even(ring, c, s)
    o, form = ring.zero, normal_form(ring, c)
    a, b = form.constants
    for u, square in zip(basis_of(ring)[1:], (a, b, o - a * b), strict=True):
        if not ring.is_zero(square):
            ratio = ring.sqrt(ring.divide(s, square))
            if ratio is not None:
                w, x, y, z = (ratio * v for v in u)
                return form.back((w, x, y, z))
    if ring.is_zero(discriminant(ring, c)):
        return None  # every other element of trace 0 has one of these squares, up to squares, or 0
    splitting = split(ring, c)
    if splitting is not None:
        return splitting.from_matrix([[o, s], [ring.one, o]])
    return _in_division_algebra(ring, form, s)


def _traceless_root_even(ring: Ring, c: Constants, s: Scalar) -> Coordinates | None:
    """Return x in characteristic 2, where scalars (and i, if t = 0) have trace 0; s is not a square."""
    o = ring.zero
    field = known_field(ring)  # finite fields of characteristic 2 have all square roots
    if ring.sqrt(c.b) is None:
        w, r = field.as_norm(s, c.b)
        return w, o, r, o
    if ring.is_zero(c.t) and ring.sqrt(c.a) is None:
        w, r = field.as_norm(s, c.a)
        return w, r, o, o
    if ring.is_zero(discriminant(ring, c)):
        return None  # all squares of elements of trace 0 are squares of scalars
    splitting = split(ring, c)
    assert splitting is not None, "j² is a square"
    return splitting.from_matrix([[o, s], [ring.one, o]])


def _in_division_algebra(ring: Ring, form: NormalForm, s: Scalar) -> Coordinates | None:
    """Return x in a division algebra (a, b | F), in the original coordinates."""
    o = ring.zero
    if ring.closure is not None:  # an algebra over the real numbers
        if ring.sign(s) > 0:
            return None
        return form.back((o, ring.sqrt(ring.divide(s, form.a)), o, o))
    if ring.is_square(s):
        return None  # its roots commute with everything that commutes with it: only scalars
    field = global_field(ring)
    if field is not None:
        root = field.traceless_root(form, s)
        return None if root is None else form.back(root)
    raise UndecidedError(
        f"whether {ring.text(s)} has a square root of trace 0 over {ring.name} was not decided"
    )


def quadric(ring: Ring, c: Constants, s: Scalar) -> Iterator[Coordinates]:
    """Yield the elements of trace 0 and norm −s over a finite field, each in constant time.

    In odd characteristic they solve ``−a·x² − b·y² + ab·z² = −s`` in the normal form. In characteristic 2,
    trace 0 means t·x = 0, and w is a square root.
    """
    o = ring.zero
    if ring.characteristic == 2:
        for x in ring.elements() if ring.is_zero(c.t) else (o,):
            for y, z in _pairs(ring):
                yield ring.sqrt(norm(c, (o, x, y, z)) + s), x, y, z
        return
    form = normal_form(ring, c)
    a, b = form.constants
    if ring.is_zero(a) or ring.is_zero(b):
        slot = b if ring.is_zero(a) else a
        free = ring.is_zero(slot)
        roots = ring.elements() if free and ring.is_zero(s) else ()
        for r in roots if free else _both_roots(ring, ring.divide(s, slot)):
            for u, v in _pairs(ring):
                yield form.back((o, u, r, v) if ring.is_zero(a) else (o, r, u, v))
        return
    scale = ring.inverse(a * b)
    for x, y in _pairs(ring):
        for z in _both_roots(ring, scale * (a * x * x + b * y * y - s)):
            yield form.back((o, x, y, z))


def _pairs(ring: Ring) -> Iterator[tuple[Scalar, Scalar]]:
    """Yield the pairs (x, y) of elements, square by square; only for x = 0 may there be no solution."""
    seen: list[Scalar] = []
    for n, x in enumerate(ring.elements()):
        seen.append(x)
        for y in seen:
            yield x, y
        for y in seen[:n]:
            yield y, x
