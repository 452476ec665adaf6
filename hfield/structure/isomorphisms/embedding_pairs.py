"""Finding i and j of one algebra inside an isomorphic one, without splitting either.

Over the real and complex numbers by square roots. Over ℚ by an isometry (`rational_embedding`).
Elsewhere, for division algebras, by a common slot: isomorphic algebras (a, b) and (p, q) have an e with
(a, b) = (a, e) = (p, e) = (p, q). Given e, three conics with a point give the elements. Over a quadratic
field and over GF(q)(t), q odd, e is built from its local classes. Over ℚ(x) it is searched for: it
runs through q times norms from F(i), so that (p, e) = (p, q) holds of itself, until (a, e) = (a, b)
holds too. In characteristic 2 one conic is enough (`inseparable`).
"""

import functools
import itertools
from collections.abc import Callable, Iterable, Iterator
from typing import Any

from hfield.errors import UndecidedError
from hfield.product import Constants, Coordinates, multiply, norm
from hfield.rings.base import Ring
from hfield.rings.functions import FunctionField
from hfield.rings.quadratic import QuadraticField
from hfield.structure.forms import normal_form
from hfield.structure.function_fields.conic_bundle import solve_conic_functions
from hfield.structure.function_fields.inseparable import embed_even
from hfield.structure.function_fields.slots_functions import common_slot_functions
from hfield.structure.isomorphisms.same_class import same_class
from hfield.structure.linear_algebra.centre import basis_of
from hfield.structure.norm_forms.zero_norms import zero_norm
from hfield.structure.quadratic_fields.conic_quadratic import solve_conic_quadratic
from hfield.structure.quadratic_fields.slots_quadratic import common_slot
from hfield.structure.rationals.rational_embedding import embed_rational

TRIALS = 600

Point = Callable[[Constants], tuple[Any, Any, Any]]


def embed_generator(ring: Ring, c: Constants, other: Constants) -> tuple[Coordinates, Coordinates]:
    """Return the images of i and j under some isomorphism, known to exist.

    Raises :class:`UndecidedError` when none was found in bounded time.
    """
    source, target = normal_form(ring, c), normal_form(ring, other)
    middle = ring.one if target.kind == "artin-schreier" else ring.zero
    inner, outer = (Constants(f.a, middle, f.b) for f in (target, source))
    if ring.name in ("RR", "CC"):
        i, j = _closed(ring, outer, inner)
    elif ring.name == "QQ":
        i, j = embed_rational(ring, outer, inner)
    elif isinstance(ring, FunctionField) and ring.characteristic == 2:
        i, j = embed_even(ring, outer, inner)
    else:
        built = _local_slot(ring, outer, [outer.a, inner.a])
        if built is None:
            assert isinstance(ring, FunctionField), "no other field has a theory of isomorphism"
            built = _slot(ring, outer, inner), functools.partial(conic_point, ring)
        i, j = _through_slot(ring, outer, inner, *built)
    # back from the normal forms: i of c is a combination of e and the normal i
    one, given, _, _ = basis_of(ring)
    scalar, factor, _, _ = source.forth(given)
    w, x, y, z = (scalar * u + factor * v for u, v in zip(one, i, strict=True))
    return target.back((w, x, y, z)), target.back(j)


def _closed(ring: Ring, outer: Constants, inner: Constants) -> tuple[Coordinates, Coordinates]:
    """Scale two of i, j, k over the real or complex numbers: those whose squares have the right signs."""
    o, e = ring.zero, ring.one
    units = [(o, e, o, o), (o, o, e, o), (o, o, o, e)]
    squares = (inner.a, inner.b, -inner.a * inner.b)
    for m, n in itertools.permutations(range(3), 2):
        ratios = ring.divide(outer.a, squares[m]), ring.divide(outer.b, squares[n])
        if ring.name == "CC" or all(ring.sign(x) > 0 for x in ratios):
            r, s = map(ring.sqrt, ratios)
            i, j = ([x * u for u in units[n]] for x, n in ((r, m), (s, n)))
            return (i[0], i[1], i[2], i[3]), (j[0], j[1], j[2], j[3])
    raise AssertionError("isomorphic real algebras have squares of the same signs")


def _slot(ring: FunctionField, outer: Constants, inner: Constants) -> Any:
    """Return a common slot of two isomorphic algebras (a, b | ℚ(x)) by search."""
    for m, n in itertools.islice(_small_pairs(ring), TRIALS):
        for first, second in ((inner, outer), (outer, inner)):
            e = first.b * (m * m - first.a * (n * n))
            if ring.is_zero(e):
                continue
            forms = [normal_form(ring, Constants(second.a, ring.zero, x)) for x in (e, second.b)]
            if same_class(ring, *forms):
                return e
    raise UndecidedError(
        f"an isomorphism exists, but none with small numbers was found over {ring.name}"
    )


def _through_slot(
    ring: Ring, outer: Constants, inner: Constants, e: Any, point: Point
) -> tuple[Coordinates, Coordinates]:
    """Return I and J in the algebra ``inner`` that satisfy the relations of ``outer``."""
    big_i, slot = _generator(ring, outer.a, inner, e, point)
    split = Constants(outer.a, ring.zero, ring.divide(outer.b, e))
    return big_i, _times_norm(ring, inner, big_i, slot, split, point)


def _generator(
    ring: Ring, a: Any, inner: Constants, e: Any, point: Point
) -> tuple[Coordinates, Coordinates]:
    """Return I and J in ``inner`` with ``I² = a, J² = e, JI = −IJ``, for a common slot e."""
    zero, one = ring.zero, ring.one
    i, j = (zero, one, zero, zero), (zero, zero, one, zero)
    split = Constants(inner.a, zero, ring.divide(e, inner.b))
    slot = _times_norm(ring, inner, i, j, split, point)
    # ((x + y·slot)·i)² = (x² − e·y²)·inner.a
    split = Constants(e, zero, ring.divide(a, inner.a))
    return _times_norm(ring, inner, slot, i, split, point), slot


def _times_norm(
    ring: Ring, c: Constants, u: Coordinates, v: Coordinates, split: Constants, point: Point
) -> Coordinates:
    """Return ``(m + n·u)·v`` with m + n·u of norm ``split.b``, where ``u² = split.a + split.t·u``."""
    m, n, r = point(split)
    scale = ring.inverse(r)
    w, x, y, z = (scale * n * s for s in u)
    return multiply(c, (w + scale * m, x, y, z), v)


def _quadratic_point(
    field: QuadraticField, known: Iterable[int], c: Constants
) -> tuple[Any, Any, Any]:
    """Return ``(w, x, y)`` ≠ 0 with ``w² = a·x² + b·y²``, given the primes of the norms of a and b."""
    x, y, w = solve_conic_quadratic(field, c.a, c.b, known)
    return w, x, y


def _local_slot(ring: Ring, c: Constants, numbers: list[Any]) -> tuple[Any, Point] | None:
    """Return a common slot built from local classes, and what solves conics; None if there is none."""
    if isinstance(ring, QuadraticField):
        e, primes = common_slot(ring, c, numbers)
        return e, functools.partial(_quadratic_point, ring, primes)
    if isinstance(ring, FunctionField) and ring.base.order is not None:
        e = common_slot_functions(ring, c, numbers)
        return None if e is None else (e, functools.partial(solve_conic_functions, ring))
    return None


def traceless_root_by_slot(ring: Ring, c: Constants, s: Any) -> Coordinates | None:
    """Return some x of trace 0 with ``x² = s`` in a division algebra (a, b), or None.

    Over GF(q)(t), q odd, None is a proof that there is none. Over a quadratic field there has to be one.
    """
    built = _local_slot(ring, c, [c.a, s])
    return None if built is None else _generator(ring, s, c, *built)[0]


def conic_point(ring: Ring, c: Constants) -> tuple[Any, Any, Any]:
    """Return ``(w, x, y)`` ≠ 0 with ``w² + t·wx − a·x² − b·y² = 0`` for a split algebra.

    A zero divisor q gives the plane q·A of elements of norm 0, which meets ⟨e, i, j⟩.
    """
    q = zero_norm(ring, c).element
    assert q is not None, "the algebra is split"
    products = [
        p for p in (multiply(c, q, u) for u in basis_of(ring)) if not all(map(ring.is_zero, p))
    ]
    for p, r in itertools.combinations([*products, products[0]], 2):
        w, x, y, z = (s * r[3] - t * p[3] for s, t in zip(p, r, strict=True))
        if not all(map(ring.is_zero, (w, x, y))):
            assert ring.is_zero(norm(c, (w, x, y, z)))
            return w, x, y
    w, x, y, _ = products[0]
    return w, x, y


def _small_pairs(ring: FunctionField) -> Iterator[tuple[Any, Any]]:
    """Run through pairs of small polynomials over ℚ, not both 0."""
    seen: list[Any] = []
    for x in _small(ring):
        seen.append(x)
        for y in seen[:-1]:
            yield x, y
            yield y, x


def _small(ring: FunctionField) -> Iterator[Any]:
    """Run through small polynomials, 0 and 1 first."""
    yield ring.zero
    yield ring.one
    digits = [ring(x) for x in (0, 1, -1, 2)]
    for degree in itertools.count(1):
        for leading, *rest in itertools.product(digits, repeat=degree + 1):
            if not ring.is_zero(leading):
                value = leading
                for x in rest:
                    value = value * ring.gen + x
                yield value
