"""Subalgebras that contain 1, over a finite field, up to conjugation by units.

Of dimension 2 they are F[x], one for each point of the projective plane of A/F. Of dimension 3 they are lines
in it that are closed under the product.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations
from typing import Any

from hfield.algebra.quaternion import Parent, Quaternion
from hfield.errors import CoercionError, TooLargeError
from hfield.exploring.subspaces import Subspace, check_finite_field, products

MAX_SUBSPACES = 50_000
"""The greatest number of subspaces that are looked at."""


class Subalgebra(Subspace):
    """A subalgebra: ``kind`` says what it is, ``conjugates`` are its images u·S·u⁻¹, itself first.

    Of dimension 2 it is a ``field``, ``split`` (F × F), or the ``dual numbers`` F[ε], ε² = 0; of dimension 3
    ``triangular matrices`` or ``local``.

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
        """What it is."""
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

    def _has_separable_element(self) -> bool:
        """Tell whether some element has no double eigenvalue: a quadratic form that is not 0."""
        sums = (x + y for x, y in combinations(self.basis, 2))
        return any(not self.algebra.ring.is_zero(_discriminant(x)) for x in (*self.basis, *sums))

    def __repr__(self) -> str:
        return f"<subalgebra of {self.algebra}: {self.span_text}, {self.kind}>"


def _discriminant(x: Quaternion) -> Any:
    t, n = x.trace(), x.norm()
    return t * t - x.ring(4) * n


def subalgebras(
    algebra: Parent, dimension: int, generators: tuple[Quaternion, ...]
) -> tuple[Subalgebra, ...]:
    """Return one subalgebra of a dimension for each class under the group that units generate.

    Raises :class:`NotFiniteError`, :class:`RingError`, :class:`TooLargeError`, and :class:`CoercionError` for
    a dimension that is not 1, 2, 3 or 4.
    """
    if dimension not in (1, 2, 3, 4):
        raise CoercionError(f"subalgebras have dimension 1, 2, 3 or 4, found {dimension!r}")
    q = check_finite_field(algebra, "subalgebras")
    if q * q + q + 1 > MAX_SUBSPACES:
        raise TooLargeError(
            f"the subalgebras of {algebra} are among {q * q + q + 1} subspaces, more than the "
            f"{MAX_SUBSPACES} that are looked at"
        )
    found = {s.key: s for s in _candidates(algebra, dimension) if _is_closed(s)}
    conjugations = [(u, u.inverse()) for u in generators]
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
    """Yield the subspaces of a dimension that contain 1."""
    one = algebra.one
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
