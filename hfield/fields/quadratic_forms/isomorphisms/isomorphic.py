"""Decide whether two algebras over one field are isomorphic, and find an isomorphism."""

import itertools
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass

from hfield.core.product import Constants, Coordinates, Scalar, conjugate, multiply, trace
from hfield.errors import MixedParentsError, UndecidedError
from hfield.fields.base.ring import Ring
from hfield.fields.linear_algebra.kernels import apply, kernel
from hfield.fields.quadratic_forms.global_field import global_field, known_field
from hfield.fields.quadratic_forms.isomorphisms.degenerate import embed_degenerate
from hfield.fields.quadratic_forms.isomorphisms.splitting import (
    division_or_splitting,
    from_zero_divisor,
)
from hfield.fields.quadratic_forms.norm_forms.zero_norms import is_division, zero_norm
from hfield.fields.quadratic_forms.normal_forms import (
    basis_of,
    discriminant,
    from_pairings,
    normal_form,
    pairing_matrix,
    root_if_known,
)

__all__ = [
    "CoordinateIsomorphism",
    "division_or_splitting",
    "is_isomorphic",
    "isomorphism",
    "same_parent",
]


@dataclass(frozen=True)
class CoordinateIsomorphism:
    """An isomorphism of the algebra with constants ``source`` onto the one with constants ``target``.

    ``images`` contains the images of e, i, j, k, as coordinates.
    """

    ring: Ring
    source: Constants
    target: Constants
    images: tuple[Coordinates, Coordinates, Coordinates, Coordinates]

    def __call__(self, q: Coordinates) -> Coordinates:
        """Return the coordinates of the image of q."""
        w, x, y, z = apply([list(row) for row in zip(*self.images, strict=True)], list(q))
        return w, x, y, z

    def inverse(self, q: Coordinates) -> Coordinates:
        """Return the coordinates of the element whose image is q."""
        if self.ring.is_zero(discriminant(self.ring, self.source)):
            columns = [*self.images, q]
            (solution,) = kernel(self.ring, [list(row) for row in zip(*columns, strict=True)], 5)
            scale = self.ring.zero - self.ring.inverse(solution[4])
            w, x, y, z = (scale * s for s in solution[:4])
            return w, x, y, z
        pairings = [_pairing(self.target, q, image) for image in self.images]
        return from_pairings(self.ring, self.source, pairings)


def _pairing(c: Constants, p: Coordinates, q: Coordinates) -> Scalar:
    value: Scalar = trace(c, multiply(c, p, conjugate(c, q)))
    return value


def verified(
    ring: Ring, c: Constants, target: Constants, i: Coordinates, j: Coordinates
) -> CoordinateIsomorphism:
    """Return the isomorphism that maps i and j to the given elements, after checking it.

    The check covers the relations and the independence of the images: ``tr(p·conj(q))`` on e, i, j, k is as
    in the source. For a degenerate algebra, for which that is not enough, independence is checked by
    elimination.
    """
    e = basis_of(ring)[0]
    k = multiply(target, i, j)
    images = (e, i, j, k)

    def equal(p: Coordinates, *terms: tuple[Scalar, Coordinates]) -> bool:
        return all(
            ring.agree(p[n], sum((x * q[n] for x, q in terms[1:]), terms[0][0] * terms[0][1][n]))
            for n in range(4)
        )

    gram = pairing_matrix(ring, c)
    rows = [list(row) for row in zip(*images, strict=True)]
    if not (
        equal(multiply(target, i, i), (c.a, e), (c.t, i))
        and equal(multiply(target, j, j), (c.b, e))
        and equal(multiply(target, j, i), (c.t, j), (ring.zero - ring.one, k))
        and all(
            ring.agree(_pairing(target, p, q), gram[r][s])
            for r, p in enumerate(images)
            for s, q in enumerate(images)
        )
        and not (ring.is_zero(discriminant(ring, c)) and kernel(ring, rows, 4))
    ):
        raise AssertionError("the map found is not an isomorphism")
    return CoordinateIsomorphism(ring, c, target, images)


def is_isomorphic(ring: Ring, c: Constants, other: Constants) -> bool:
    """Return whether two algebras over the same field are isomorphic.

    Raises :class:`UndecidedError` if no theory is available for the field.
    """
    if _same(ring, c, other):
        return True
    if not ring.is_field:
        raise UndecidedError(f"{ring.no_field}: isomorphism is decided over fields only")
    degenerate = [ring.is_zero(discriminant(ring, x)) for x in (c, other)]
    if any(degenerate):
        return all(degenerate) and embed_degenerate(ring, c, other) is not None
    if ring.order is not None:
        return True
    with _primes_of_both(ring, c, other):
        field = global_field(ring)
        if field is not None:
            return field.same_class(normal_form(ring, c), normal_form(ring, other))
    divisions = [is_division(ring, x) for x in (c, other)]
    if divisions[0] != divisions[1]:
        return False
    if not divisions[0] or ring.closure == "real closed":
        return True
    raise UndecidedError(
        f"whether two division algebras over {ring.name} are isomorphic is not decided"
    )


def _same(ring: Ring, c: Constants, other: Constants) -> bool:
    """Return whether the constants are known to be equal."""
    try:
        return all(x is y or ring.equal(x, y) for x, y in zip(c, other, strict=True))
    except UndecidedError:
        return False


def isomorphism(ring: Ring, c: Constants, other: Constants) -> CoordinateIsomorphism | None:
    """Return an explicit isomorphism onto the algebra with constants ``other``, or None if there is none.

    Split algebras are compared through M₂(F); for a division algebra, i and j are found in the other algebra.
    Raises :class:`UndecidedError` as :func:`is_isomorphic` does, and if nothing was found in bounded time.
    """
    e = basis_of(ring)
    if _same(ring, c, other):
        return verified(ring, c, other, e[1], e[2])
    if not is_isomorphic(ring, c, other):
        return None
    if ring.is_zero(discriminant(ring, c)):
        found = embed_degenerate(ring, c, other)
        assert found is not None, "the two are isomorphic"
        return verified(ring, c, other, *found)
    with _primes_of_both(ring, c, other):
        return verified(ring, c, other, *_images(ring, c, other))


def _images(ring: Ring, c: Constants, other: Constants) -> tuple[Coordinates, Coordinates]:
    """Return the images of i and j under an isomorphism of nondegenerate algebras."""
    if ring.closure is None:
        q, p = zero_norm(ring, c).element, zero_norm(ring, other).element
        if q is not None and p is not None:
            left, right = from_zero_divisor(ring, c, q), from_zero_divisor(ring, other, p)
            return right.from_matrix(left.i), right.from_matrix(left.j)
    return embed_generator(ring, c, other)


def _primes_of_both(ring: Ring, *algebras: Constants) -> AbstractContextManager[None]:
    """Share the primes found in one of the constants with the others."""
    field = global_field(ring)
    if field is None:
        return nullcontext()
    return field.sharing_primes(*(normal_form(ring, c) for c in algebras))


def same_parent(ring: Ring, other: Ring) -> None:
    """Raise :class:`MixedParentsError` unless two algebras are over the same field."""
    if ring != other:
        raise MixedParentsError(
            f"one algebra is over {ring.name}, the other over {other.name}: change the ring of one of them "
            "with change_ring() first"
        )


def embed_generator(ring: Ring, c: Constants, other: Constants) -> tuple[Coordinates, Coordinates]:
    """Return the images of i and j under some isomorphism, which is known to exist.

    Raises :class:`UndecidedError` if none was found in bounded time.
    """
    source, target = normal_form(ring, c), normal_form(ring, other)
    middle = ring.one if target.kind == "artin-schreier" else ring.zero
    inner, outer = (Constants(f.a, middle, f.b) for f in (target, source))
    if ring.closure is not None:
        found = by_multiples(ring, outer, inner)
        assert found is not None, "isomorphic real algebras have squares of the same signs"
        i, j = found
    else:
        i, j = known_field(ring).embed(outer, inner)
    # back from the normal forms: i of c is a combination of e and the normal i
    one, given, _, _ = basis_of(ring)
    scalar, factor, _, _ = source.forth(given)
    w, x, y, z = (scalar * u + factor * v for u, v in zip(one, i, strict=True))
    return target.back((w, x, y, z)), target.back(j)


def by_multiples(
    ring: Ring, outer: Constants, inner: Constants
) -> tuple[Coordinates, Coordinates] | None:
    """Return multiples of two of i, j, k with the squares a and b of ``outer``; None if the roots needed do
    not exist.
    """
    units = basis_of(ring)[1:]
    squares = (inner.a, inner.b, -inner.a * inner.b)
    for chosen in itertools.permutations(range(3), 2):
        ratios = (
            ring.divide(x, squares[k]) for x, k in zip((outer.a, outer.b), chosen, strict=True)
        )
        roots = [root_if_known(ring, x) for x in ratios]
        if None not in roots:
            i, j = ([x * u for u in units[k]] for x, k in zip(roots, chosen, strict=True))
            return (i[0], i[1], i[2], i[3]), (j[0], j[1], j[2], j[3])
    return None
