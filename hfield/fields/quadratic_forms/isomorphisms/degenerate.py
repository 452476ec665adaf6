"""Degenerate algebras, (t² + 4a)·b = 0, over a field: when they are isomorphic, and how.

In characteristic not 2 they are F[√a] with an ideal of square 0 that anticommutes with √a, or, without √a,
the exterior algebra of a plane. In characteristic 2 they are either [a, 0), determined by the class of a
modulo all y² + y, or, for t = 0, the commutative algebra F[√a, √b]. Over a finite field or k(t), where [F :
F²] ≤ 2, the latter is F[ε, δ] with ε² = δ² = 0 if a and b are squares, else F^(1/2)[ε].
"""

from hfield.core.product import Constants, Coordinates, Scalar
from hfield.fields.base.ring import Ring
from hfield.fields.quadratic_forms.global_field import known_field
from hfield.fields.quadratic_forms.normal_forms import (
    NormalForm,
    basis_of,
    normal_form,
)

Pair = tuple[Coordinates, Coordinates]


def embed_degenerate(ring: Ring, c: Constants, other: Constants) -> Pair | None:
    """Return the images of i and j under some isomorphism of two degenerate algebras, or None."""
    if ring.characteristic != 2:
        source, target = normal_form(ring, c), normal_form(ring, other)
        found = _with_radical(ring, source, target)
        if found is None:
            return None
        i, j = map(target.back, found)
        half = ring.divide(c.t, ring(2))  # i is the normal one plus t/2
        return (i[0] + half, i[1], i[2], i[3]), j
    if ring.is_zero(c.t) or ring.is_zero(other.t):
        return _inseparable(ring, c, other) if ring.equal(c.t, other.t) else None
    y = _artin_schreier(ring, normal_form(ring, c).a + normal_form(ring, other).a)
    if y is None:
        return None
    o = ring.zero
    return (c.t * y, ring.divide(c.t, other.t), o, o), (o, o, ring.one, o)


def _with_radical(ring: Ring, source: NormalForm, target: NormalForm) -> Pair | None:
    """Map a root of a to a root of a and the ideal to the ideal, between normal forms (a, b), ab = 0."""
    _, i, j, _ = basis_of(ring)
    swapped = [not ring.is_zero(form.b) for form in (source, target)]
    a, p = (
        form.b if turn else form.a for form, turn in zip((source, target), swapped, strict=True)
    )
    if ring.is_zero(a) or ring.is_zero(p):
        return (i, j) if ring.equal(a, p) else None
    r = ring.sqrt(ring.divide(a, p))
    if r is None:
        return None
    root, null = (j, i) if swapped[1] else (i, j)
    w, x, y, z = (r * u for u in root)
    return (null, (w, x, y, z)) if swapped[0] else ((w, x, y, z), null)


def _artin_schreier(ring: Ring, x: Scalar) -> Scalar | None:
    """Return y with y² + y = x in a finite field or function field of characteristic 2, or None."""
    if ring.order is None:
        return known_field(ring).artin_schreier(x)
    return next(iter(ring.roots([x, ring.one, ring.one])), None)


def _inseparable(ring: Ring, c: Constants, other: Constants) -> Pair | None:
    """Map commutative algebras of characteristic 2, t = 0."""
    o = ring.zero
    (m, n), (p, q) = ([ring.sqrt(x) for x in (y.a, y.b)] for y in (c, other))
    if m is not None and n is not None:
        if p is None or q is None:
            return None
        return (m + p, ring.one, o, o), (n + q, o, ring.one, o)
    if p is not None and q is not None:
        return None
    field = known_field(ring)  # finite fields of characteristic 2 have all square roots
    turn = p is not None  # then j is the one whose square is not a square
    s, rest = (other.b, other.a) if turn else (other.a, other.b)
    w, r = field.as_norm(rest, s)
    images = []
    for n, x in enumerate((c.a, c.b)):
        u, v = field.as_norm(x, s)
        null = ring.one if (n == 1) == (m is None) else o  # one image has a nilpotent added
        pair = (v + null * r, null)
        y, z = pair[::-1] if turn else pair
        images.append((u + null * w, y, z, o))
    return images[0], images[1]
