"""Subalgebras that contain 1, over a finite field or ℤ/n, up to conjugation by units.

Over a field the subalgebras of dimension 2 are F[x], one for each point of the projective plane of A/F. Those
of dimension 3 correspond to lines in this plane that are closed under the product. Over ℤ/n they are the
submodules of A/(ℤ/n) whose elements, together with 1, are closed under the product.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations, product

from hfield.algebra.quaternion import Parent, Quaternion
from hfield.core.product import Scalar
from hfield.errors import CoercionError, TooLargeError
from hfield.exploring.elements import Elements
from hfield.exploring.labels import order_of_ring
from hfield.exploring.properties import Condition
from hfield.exploring.submodules import Submodule, check_listed, products
from hfield.exploring.unit_groups import unit_group

MAX_SUBMODULES = 50_000
"""The greatest number of submodules that are tried."""


class Subalgebra(Submodule):
    """A subalgebra with its isomorphism type ``kind``; ``conjugates`` are its images u·S·u⁻¹, itself
    first.

    In dimension 2 the type is ``field``, ``split`` (F × F), or ``dual numbers`` (F[ε], ε² = 0); in dimension
    3 it is ``triangular matrices`` or ``local``. Over ℤ/n it is ``local``, a ``product of 2 local rings`` if
    the subalgebra is commutative, or ``neither local nor commutative``.

    >>> from hfield import H
    >>> for S in H("GF(3)").subalgebras(dimension=2):
    ...     print(S.kind, S.basis, len(S.conjugates))
    field (1, k) 3
    split (1, j + k) 6
    dual numbers (1, i + j + k) 4
    """

    conjugates: tuple[Subalgebra, ...]

    @property
    def kind(self) -> str:
        """The isomorphism type in words."""
        if not self.algebra.ring.is_field:
            return self._kind_over_residues()
        if self.dimension == 1:
            return "field"
        if self.dimension == 4:
            return "the algebra"
        x = self.basis[1]
        if self.dimension == 2:
            roots = self.algebra.ring.roots(list(x.characteristic_polynomial()))
            return ("field", "dual numbers", "split")[
                len({self.algebra.ring.key(r) for r in roots})
            ]
        return "triangular matrices" if self._has_separable_element() else "local"

    def _kind_over_residues(self) -> str:
        """Return the type over ℤ/n; a finite ring is local if and only if 0 and 1 are its only
        idempotents.
        """
        if all(q in self for q in self.algebra.basis):
            return "the algebra"
        idempotents = sum(q in self for q in Elements(self.algebra, Condition("idempotents")))
        if idempotents == 2:
            return "local"
        if all(x * y == y * x for x, y in combinations(self.basis, 2)):
            return f"product of {idempotents.bit_length() - 1} local rings"
        return "neither local nor commutative"

    def _has_separable_element(self) -> bool:
        """Return whether some element has distinct eigenvalues, that is, a certain quadratic form
        is not 0.
        """
        sums = (x + y for x, y in combinations(self.basis, 2))
        return any(not self.algebra.ring.is_zero(_discriminant(x)) for x in (*self.basis, *sums))

    def __repr__(self) -> str:
        return f"<subalgebra of {self.algebra}: {self.span_text}, {self.kind}>"


def _discriminant(x: Quaternion) -> Scalar:
    t, n = x.trace(), x.norm()
    found: Scalar = t * t - x.ring(4) * n
    return found


def subalgebras(algebra: Parent, dimension: int) -> tuple[Subalgebra, ...]:
    """Return one subalgebra of a given dimension from each class under conjugation by units.

    Over ℤ/n the dimension is the least number of generators as a module. Raises :class:`NotFiniteError`,
    :class:`RingError`, :class:`TooLargeError`, and :class:`CoercionError` unless the dimension is 1, 2, 3 or
    4.
    """
    if dimension not in (1, 2, 3, 4):
        raise CoercionError(f"subalgebras have dimension 1, 2, 3 or 4, found {dimension!r}")
    q = check_listed(algebra, "subalgebras")
    candidates = q * q + q + 1 if algebra.ring.is_field else _number_of_forms(q)
    if candidates > MAX_SUBMODULES:
        raise TooLargeError(
            f"the subalgebras of {algebra} are among {candidates} submodules, more than the {MAX_SUBMODULES} "
            "that are examined"
        )
    found = {s.key: s for s in _candidates(algebra, dimension) if _is_closed(s)}
    conjugations = [(u, u.inverse()) for u in unit_group(algebra).generators]
    out = []
    while found:
        first = next(iter(found.values()))
        orbit = {first.key: found.pop(first.key)}
        queue = [first]
        while queue:
            one = queue.pop()
            for u, inverse in conjugations:
                image = Subalgebra(algebra, [u * x * inverse for x in one.basis])
                if image.key not in orbit:
                    orbit[image.key] = found.pop(image.key)
                    queue.append(image)
        for s in orbit.values():
            s.conjugates = (s, *(other for other in orbit.values() if other is not s))
        out.append(first)
    return tuple(out)


def _is_closed(s: Subalgebra) -> bool:
    return s.dimension <= 2 or all(x in s for x in products(s.basis, s.basis))


def _candidates(algebra: Parent, dimension: int) -> Iterator[Subalgebra]:
    """Yield the submodules of a given dimension that contain 1."""
    one = algebra.one
    if not algebra.ring.is_field:
        for rows in _hermite_forms(order_of_ring(algebra)):
            found = Subalgebra(algebra, [one, *(algebra(0, *row) for row in rows)])
            if found.dimension == dimension:
                yield found
        return
    if dimension in (1, 4):
        yield Subalgebra(algebra, algebra.basis[:dimension])
        return
    o, e = algebra.ring.zero, algebra.ring.one
    scalars = list(algebra.ring.elements())
    points = [
        (o, o, e),
        *((o, e, z) for z in scalars),
        *((e, y, z) for y in scalars for z in scalars),
    ]
    for point in points:
        if dimension == 2:
            yield Subalgebra(algebra, [one, algebra(o, *point)])
            continue
        # the plane of the vectors (x, y, z) that a linear form with these coefficients kills
        a, b, c = point
        vectors = [(b, -a, o), (c, o, -a), (o, c, -b)]
        yield Subalgebra(algebra, [one, *(algebra(o, *v) for v in vectors)])


def _number_of_forms(n: int) -> int:
    """Return the number of triples of rows that :func:`_hermite_forms` tries."""
    divisors = [d for d in range(1, n + 1) if n % d == 0]
    return len(divisors) * sum(divisors) * sum(d * d for d in divisors)


def _hermite_forms(n: int) -> Iterator[tuple[tuple[int, int, int], ...]]:
    """Yield a basis of each lattice between n·ℤ³ and ℤ³, in Hermite normal form."""
    divisors = [d for d in range(1, n + 1) if n % d == 0]
    for d, e, f in product(divisors, repeat=3):
        for z in range(f):
            if n // e * z % f:
                continue  # n/e times the second row, without its pivot, is a multiple of the third
            for x, y in product(range(e), range(f)):
                # n/d times the first row, without its pivot, is a combination of the others
                times, left = divmod(n // d * x, e)
                if not left and (n // d * y - times * z) % f == 0:
                    yield (d, x, y), (0, e, z), (0, 0, f)
