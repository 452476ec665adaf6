"""Tensor products in the Brauer group, and corestrictions."""

from __future__ import annotations

from collections.abc import Callable, Collection, Hashable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import chain, count, islice, product, starmap
from typing import Any

from hfield.algebra.embedding import embedding
from hfield.algebra.quaternion import Parent, Quaternion
from hfield.algebra.structure import is_central_simple
from hfield.algebra.structure.elements.trace_and_norm import element_of
from hfield.core.product import Constants, Scalar
from hfield.errors import CoercionError, MixedParentsError, RingError, UndecidedError
from hfield.fields.base.ring import E, Ring, WithIntegers
from hfield.fields.quadratic_forms import is_division, is_isomorphic, ramified_places
from hfield.fields.quadratic_forms.global_field import GlobalField, global_field, known_field
from hfield.fields.quadratic_forms.norm_forms.residue_forms import no_zero

BOUND = 3  # coordinates of pure elements that are tried for a common slot
MAX_CANDIDATES = 50_000  # scalars tried if local conditions determine which are slots
MAX_CONICS = 10  # of these so many are tried: a conic may be too hard
Slot = tuple[Scalar, Quaternion, Quaternion]
ALBERT = (
    "A. A. Albert, Proc. AMS 35 (1972): the index is at most 2 exactly where there is a common slot"
)
GLOBAL = "over this field the index of a class is its order (Albert, Brauer, Hasse, Noether)"


class TensorProduct:
    """The tensor product ``A ⊗ B`` of central simple algebras over one field: class, index, a common slot.

    >>> from hfield import H, QuaternionAlgebra
    >>> T = H("QQ").tensor(QuaternionAlgebra(-1, -3))
    >>> T.brauer_class, T.index, T.common_slot is not None
    ((2, 3), 2, True)
    """

    def __init__(self, first: Parent, second: Parent) -> None:
        if first.ring != second.ring:
            raise MixedParentsError(
                f"{first} is over {first.ring}, {second} over {second.ring}: change the ring of one of them "
                "with change_ring() first"
            )
        for A in (first, second):
            if not is_central_simple(A.ring, A.constants):
                raise CoercionError(
                    f"{A} is not central simple, so it has no class in the Brauer group"
                )
        self.first, self.second = first, second

    def __repr__(self) -> str:
        return f"{self.first} ⊗ {self.second}"

    @cached_property
    def brauer_class(self) -> tuple[Hashable, ...]:
        """The places where the product ramifies: those where exactly one of the two factors ramifies.

        Raises :class:`UndecidedError` over a field without a theory of places.
        """
        one, other = (ramified_places(A.ring, A.constants) for A in (self.first, self.second))
        return (*(p for p in one if p not in other), *(p for p in other if p not in one))

    @cached_property
    def _index(self) -> tuple[int, str]:
        F, one, other = self.first.ring, self.first.constants, self.second.constants
        if is_isomorphic(F, one, other):
            return 1, "the two are isomorphic, and each is its own opposite"
        if not (is_division(F, one) and is_division(F, other)):
            return 2, "one of the two splits, the other does not"
        field = global_field(F)
        if field is not None and field.splits_if_unramified:
            return 2, GLOBAL
        if self._slot is not None:
            return 2, ALBERT
        reason = no_zero(F, [*pure_form(F, one), *(-c for c in pure_form(F, other))])
        if reason is not None:
            return 4, f"Albert's form has no zero but 0: {reason}"
        raise UndecidedError(
            f"whether the index of {self} is 2 or 4 is not decided over {F.name}: no common slot was found "
            f"among pure elements with coordinates up to {BOUND}, and no residues show that there is none"
        )

    @property
    def index(self) -> int:
        """The index (1, 2 or 4): the degree of the division algebra in the class. Raises UndecidedError."""
        return self._index[0]

    @property
    def reason(self) -> str:
        """The reason for the value of the index. Raises :class:`UndecidedError`."""
        return self._index[1]

    @cached_property
    def _slot(self) -> Slot | None:
        """Return a common slot, or None if a bounded search finds none.

        If one of the two splits, any slot of the other is common; if they are isomorphic, every slot is. Over
        a global field a scalar is a common slot unless it is a square at a place where one of them ramifies.
        """
        one, other = self.first, self.second
        if _splits(one):
            return self._given(next(_slots(other, 1)))
        if _splits(other):
            return self._given(next(_slots(one, 1)))
        F = one.ring
        field = global_field(F)
        tried: Iterator[Slot | None] = map(self._given, _slots(one, BOUND))
        if field is not None and field.splits_if_unramified:
            own, others = (ramified_places(F, A.constants) for A in (one, other))
            if set(own) != set(others):
                # squares of elements of the first are local squares only at places where it is not
                # ramified
                places = [*(v for v in others if v not in own), *own]
                tried = starmap(self._of_square, self._candidates(field, places))
            tried = islice(tried, MAX_CONICS)
        return next(filter(None, tried), None)

    def _candidates(
        self, field: GlobalField, places: Collection[Hashable]
    ) -> Iterator[tuple[Scalar, Quaternion | None]]:
        """Yield small scalars that are squares at none of the places, with a known root if there is one.

        The places are those where the two algebras ramify. Small elements of the field alternate with squares
        of small elements of the first algebra. The field elements more often have the right signs at real
        places; the squares fit more often if many places ramify.
        """
        F = field.ring
        scalars = ((F(_numbered(F, m)), None) for n in count(1) for m in (n, -n))
        squares = ((-x.norm(), x) for x in _slots(self.first, MAX_CANDIDATES))
        in_turn = chain.from_iterable(zip(scalars, squares, strict=False))
        for a, x in islice(in_turn, MAX_CANDIDATES):
            local = any(field.has_root_at(v, F.zero, -a) for v in places)
            if not local and not F.is_square(a):
                yield a, x

    def _given(self, z: Quaternion) -> Slot | None:
        """Return the common slot z² for an element z of trace 0 of either algebra, or None if none
        is found.
        """
        return self._of_square(-z.norm(), z)

    def _of_square(self, a: Scalar, given: Quaternion | None = None) -> Slot | None:
        """Return the common slot a with an element of each algebra, or None if one of them is not found."""
        found = []
        for A in (self.first, self.second):
            x = given if given is not None and given.algebra is A else _square_root(A, a)
            if x is None:
                return None
            found.append(x)
        return a, found[0], found[1]

    @property
    def common_slot(self) -> Slot | None:
        """A scalar a with an element x of the first and y of the second, ``x² = y² = a``; None if the index
        is 4.

        Raises :class:`UndecidedError` if the search finds no common slot.
        """
        if self.index == 4:
            return None
        if self._slot is None:
            raise UndecidedError(f"{self} has a common slot, but a bounded search found none")
        return self._slot


def pure_form(F: Ring[E], c: Constants[E]) -> list[E]:
    """Return the squares of three orthogonal pure elements, in characteristic other than 2."""
    a = c.a if F.is_zero(c.t) else c.t * c.t + c.a * F(4)
    return [a, c.b, -a * c.b]


def pure_elements(A: Parent, bound: int) -> Iterator[Quaternion]:
    """Yield small nonzero elements of trace 0, one of each pair ±x."""
    e, i, j, k = A.basis
    t = A.constants.t  # the trace of i, and of k it is 0
    pure = [i * 2 - e * t, j, k] if A.ring.characteristic != 2 else [e, j, k] if t else [e, i, j, k]
    for size in range(1, bound + 1):
        digits = sorted(range(-size, size + 1), key=lambda n: (abs(n), n < 0))
        shell = (c for c in product(digits, repeat=len(pure)) if max(map(abs, c)) == size)
        for c in sorted(shell, key=lambda c: sum(map(abs, c))):
            if next(n for n in c if n) > 0:
                terms = (q * _numbered(A.ring, n) for q, n in zip(pure, c, strict=True))
                yield sum(terms, A.scalar(0))


def _numbered(F: Ring, n: int) -> Scalar | int:
    """Return the small element of number n in a field; its negative has the number −n.

    Over a number field the digits of n to the base 3 (−1, 0 and 1) are added in turn to the coordinates in
    the integral basis. Over functions in characteristic p the result is the polynomial with the digits of n
    to the base p. Over all other fields it is n itself.
    """
    if n < 0:
        return -_numbered(F, -n)
    if isinstance(F, WithIntegers):
        coordinates, scale = [0] * F.degree, 1
        while n:
            for k in range(F.degree):
                digit = (n + 1) % 3 - 1
                coordinates[k] += digit * scale
                n = (n - digit) // 3
            scale *= 3
        combination: Scalar | int = sum(
            w * c for w, c in zip(F.integral_basis(), coordinates, strict=True)
        )
        return combination
    if not F.characteristic or F.order is not None or F.gen_name is None:
        return n
    total: Scalar = F.zero
    power = F.one
    while n:
        n, digit = divmod(n, F.characteristic)
        total, power = total + power * F(digit), power * F.gen
    return total


def _slots(A: Parent, bound: int) -> Iterator[Quaternion]:
    """Yield small elements of trace 0 that are not scalars and whose square is not 0."""
    return (x for x in pure_elements(A, bound) if x.vector_part and not A.ring.is_zero(x.norm()))


def _splits(A: Parent) -> bool:
    """Return whether an algebra is known to split."""
    try:
        return not is_division(A.ring, A.constants)
    except UndecidedError:
        return False


def _square_root(A: Parent, d: Scalar) -> Quaternion | None:
    """Return a nonscalar element of trace 0 with square d; None if none is found."""
    try:
        q = element_of(A.ring, A.constants, A.ring.zero, -d)
    except UndecidedError:
        return None
    return None if q is None else A(*q)


@dataclass(frozen=True)
class Corestriction:
    """The corestriction of an algebra; ``algebra`` is a quaternion algebra over the base in the same class.

    ``above`` lists, for each place of the base below a ramified place, the ramified places above it.
    Invariants are added, so the places of ``brauer_class`` are those with an odd number of ramified places
    above.
    """

    algebra: Parent
    above: dict[Hashable, tuple[Hashable, ...]]

    @property
    def brauer_class(self) -> tuple[Hashable, ...]:
        """The places of the base where the corestriction ramifies."""
        return tuple(v for v, places in self.above.items() if len(places) % 2)

    @property
    def index(self) -> int:
        """The index: 1 if the corestriction splits, else 2. Over a number field the index of a class is its
        order.
        """
        return 2 if self.brauer_class else 1


def corestriction(A: Parent, base: Ring) -> Corestriction:
    """Return the corestriction of an algebra over a number field to ℚ or another subfield.

    The invariants of the places above each place are added (J.-P. Serre, *Local Fields*, XI.2.1 and
    XIII.3.7). Raises :class:`RingError` for fields of another kind, and :class:`CoercionError` if the base is
    not a known subfield or the algebra is degenerate.
    """
    F = A.ring
    for K in (F, base):
        if K.characteristic or not isinstance(K, WithIntegers):
            raise RingError(
                f"corestrictions are from number fields to their subfields, not from {F.name} to {base.name}"
            )
    if not is_central_simple(F, A.constants):
        raise CoercionError(f"{A} is not central simple")
    image = embedding(base, F)
    above: dict[Hashable, list[Hashable]] = {}
    for w in ramified_places(F, A.constants):
        above.setdefault(_below(w, base, image), []).append(w)
    field = known_field(base)
    odd = [v for v, places in above.items() if len(places) % 2]
    found = type(A)(base, *field.with_ramification(odd))  # type: ignore[call-arg]
    places = {v: tuple(places) for v, places in above.items()}
    return Corestriction(found, places)


def _below(w: Any, base: Any, image: Callable[[Any], Any]) -> Hashable:
    """Return the place of the base that lies under a finite or real place of an extension."""
    finite = isinstance(w, int) or getattr(w, "is_finite", False)
    if base.degree == 1:
        return "inf" if not finite else w if isinstance(w, int) else w.p
    if finite:
        below: Iterator[Hashable] = (
            v for v in base.primes_above(w.p) if all(image(x) in w for x in v.generators)
        )
        return next(below)
    left, bound = list(base.real_places()), 1
    while w.sign(image(base.gen - bound)) > 0 or w.sign(image(base.gen + bound)) < 0:
        bound *= 2
    low, high = Fraction(-bound), Fraction(bound)
    while len(left) > 1:  # different places give the generator different values
        middle = (low + high) / 2
        x = base.gen - base(middle)
        own = w.sign(image(x))
        left = [v for v in left if v.sign(x) == own]
        low, high = (low, middle) if own < 0 else (middle, high)
    return left[0]  # type: ignore[no-any-return]
