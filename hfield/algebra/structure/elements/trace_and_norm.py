"""Find elements of given trace and norm, that is, embeddings of quadratic extensions."""

from __future__ import annotations

from collections.abc import Hashable, Iterator
from itertools import product

from hfield.algebra.structure.elements.square_roots import quadric, square_roots
from hfield.core.product import Constants, Coordinates, norm, trace
from hfield.errors import UndecidedError
from hfield.fields.base.ring import E, Ring
from hfield.fields.quadratic_forms.global_field import global_field, known_field
from hfield.fields.quadratic_forms.isomorphisms.splitting import split
from hfield.fields.quadratic_forms.norm_forms.zero_norms import is_division
from hfield.fields.quadratic_forms.normal_forms import normal_form


def element_of(ring: Ring[E], c: Constants[E], t: E, n: E) -> Coordinates[E] | None:
    """Return a nonscalar element of trace t and norm n in a central simple algebra, or None.

    Raises :class:`UndecidedError` if neither is known.
    """
    q = _element_of(ring, c, t, n)
    if q is not None and not (ring.agree(trace(c, q), t) and ring.agree(norm(c, q), n)):
        raise AssertionError("an element that was found has another trace or norm")
    return q


def _element_of(ring: Ring[E], c: Constants[E], t: E, n: E) -> Coordinates[E] | None:
    if not is_division(ring, c):
        matrices = split(ring, c)
        assert matrices is not None, "the algebra has zero divisors"
        return matrices.from_matrix(((ring.zero, -n), (ring.one, t)))
    if ring.characteristic == 2 and not ring.is_zero(t):
        scale = ring.inverse(t)
        form = normal_form(ring, c)
        root = known_field(ring).of_trace_one(form, n * scale * scale)
        if root is None:
            return None
        w, x, y, z = (t * u for u in form.back(root))
        return w, x, y, z
    half = t * ring.inverse(ring(2)) if ring.characteristic != 2 else ring.zero
    o = ring.zero
    root = square_roots(ring, c, (half * half - n, o, o, o)).quadric
    if root is None or all(map(ring.is_zero, root[1:])):
        return None
    return root[0] + half, *root[1:]


def obstruction(ring: Ring[E], c: Constants[E], t: E, n: E) -> Hashable | None:
    """Return a place at which no element has trace t and norm n, or None.

    At this place the algebra ramifies and x² − t·x + n has a root, or a quadratic form has no zero.
    """
    field = global_field(ring)
    if field is None:
        return None
    try:
        return field.obstruction(normal_form(ring, c), t, n)
    except UndecidedError:
        return None


def all_elements_of(ring: Ring[E], c: Constants[E], t: E, n: E) -> Iterator[Coordinates[E]]:
    """Yield the elements of trace t and norm n of any algebra over a finite field."""
    if ring.characteristic != 2:
        half = ring.divide(t, ring(2))
        for w, x, y, z in quadric(ring, c, half * half - n):
            yield w + half, x, y, z
    elif ring.is_zero(t):
        yield from quadric(ring, c, n)
    elif not ring.is_zero(c.t):
        x = ring.divide(t, c.t)
        for y, z in product(ring.elements(), repeat=2):
            for w in ring.roots([norm(c, (ring.zero, x, y, z)) + n, t, ring.one]):
                yield w, x, y, z
