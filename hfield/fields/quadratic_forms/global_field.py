"""The protocol of the arithmetic of fields with places; each kind of field has one object.

A kind is a class of rings that names its ``theory``: the registry contains the :class:`GlobalField` of that
name. ``docs/reference/structure.md`` lists the files to change for a new kind. All other modules call
:func:`global_field`.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Hashable, Iterable, Iterator, Mapping, Sequence
from contextlib import AbstractContextManager, nullcontext
from typing import TYPE_CHECKING, Generic

from hfield.core.factorisation import Factors, known_primes, shared_primes
from hfield.core.primality import WORD
from hfield.core.product import Constants, Coordinates, Scalar
from hfield.errors import RingError, UndecidedError, shorten
from hfield.fields.base.registry import REGISTRY
from hfield.fields.base.ring import E, Ring
from hfield.fields.quadratic_forms.minimal_conics import Vector
from hfield.fields.quadratic_forms.norm_forms.local_order import hyperbolic_plane, unit_and_prime
from hfield.fields.quadratic_forms.norm_forms.zero_norm_answer import ZeroNorm
from hfield.fields.quadratic_forms.normal_forms import NormalForm

if TYPE_CHECKING:
    from typing import Any

    from typing_extensions import TypeVar

    from hfield.fields.base.finite_places import FinitePlace

    P = TypeVar("P", bound=Hashable, default=Any)  # ``GlobalField`` alone: of any kind of places
else:
    from typing import TypeVar

    P = TypeVar("P")  # a place of the field


def global_field(ring: Ring) -> GlobalField | None:
    """Return the arithmetic of a field with places, or None for a ring of any other kind."""
    theory = REGISTRY.theory_of(ring)
    if theory is None:
        return None
    kind: type[GlobalField] = theory.arithmetic()
    return kind.of(ring)


def known_field(ring: Ring) -> GlobalField:
    """Return the arithmetic of a field with places. Raises :class:`UndecidedError` for any other ring."""
    field = global_field(ring)
    if field is None:
        raise UndecidedError(
            f"{ring.name} has no places: number fields and function fields have them"
        )
    return field


def field_named_by(*things: object) -> Ring | None:
    """Return the field with places that the first of some elements and places belongs to.

    Numbers that belong to no field have a method ``common_field`` that returns one. Raises :class:`RingError`
    if there is none.
    """
    fields = (getattr(x, "field", None) for x in things)
    named = next((F for F in fields if isinstance(F, Ring) and F.theory), None)
    finders = (x.common_field for x in things if hasattr(x, "common_field"))
    finder = None if named else next(finders, None)
    found: Ring | None = finder(*things) if finder else named
    return found


def no_flag(ring: Ring) -> RingError:
    """Return the error for ramification given by primes and a flag over a ring other than ℚ."""
    return RingError(
        f"algebras over {shorten(ring.name)} are not made from ramified primes and a flag: expected QQ, or a "
        "number field and its places, infinite ones too"
    )


class GlobalField(ABC, Generic[E, P]):
    """The arithmetic of a field with places, for quaternion algebras over it.

    Forms are nondegenerate normal forms (a, b | F), or [a, b | F) in characteristic 2. The theory is that of
    J. Voight, *Quaternion Algebras*, chapters 12 and 14. If something is not found in bounded time, or
    requires a factorisation that is too hard, :class:`hfield.UndecidedError` is raised.
    """

    ring: Ring[E]  # the field; its class names this one
    splits_if_unramified = True  # false if residues do not determine a constant algebra (Faddeev)
    cited = "Hilbert symbols at the places (Voight, Quaternion Algebras, chapter 12)"

    def __init__(self, ring: Ring[E]) -> None:
        self.ring = ring

    @classmethod
    def of(cls, ring: Ring) -> GlobalField:
        """Return the arithmetic of a field of this kind; a kind with several cases selects one here."""
        return cls(ring)

    # --- places and symbols --------------------------------------------------------------------

    @abstractmethod
    def read_place(self, text: object) -> Hashable:
        """Return the place that a text names; a place is returned as it is. Raises :class:`RingError`."""

    def hilbert_symbol(
        self, a: Scalar | str, b: Scalar | str, place: object, factors: Factors | None
    ) -> int:
        """Return 1 if the algebra of a and b splits over the completion at a place, else −1.

        ``factors`` may contain primes of the norms of a and b, if the symbol depends on other places. Raises
        :class:`RingError` for a 0 and for an invalid place, and :class:`UndecidedError` if completions are
        not local fields.
        """
        raise UndecidedError(f"the completions of {self.ring} are not local fields: use residues")

    def _nonzero(self, a: Scalar | str, b: Scalar | str) -> tuple[E, E]:
        """Return the elements a and b, after checking that neither is 0; in characteristic 2 the first may be
        0.
        """
        x, y = self.ring(a), self.ring(b)
        even = self.ring.characteristic == 2
        if self.ring.is_zero(y) or (not even and self.ring.is_zero(x)):
            raise RingError(
                "a Hilbert symbol is defined for nonzero elements only, and one of these is 0"
            )
        return x, y

    @abstractmethod
    def ramified(self, form: NormalForm[E]) -> tuple[P, ...]:
        """Return the places at which a form does not split: finite ones in ascending order, then infinite
        ones.

        If the field is not a global field in the strict sense, these are the places with a nontrivial residue
        (Faddeev).
        """

    @abstractmethod
    def discriminant(self, ramified: tuple[P, ...]) -> object:
        """Return the product of the finite places among the ramified ones, in the field's notation for
        ideals.
        """

    def why_ramified(self, form: NormalForm[E], places: tuple[P, ...]) -> str:
        """Return the reason, as text, why an algebra that ramifies at the places has no zero divisors."""
        shown = ", ".join(map(str, places))
        return (
            f"the algebra is ramified at the places {shown}, so it has no zero divisor even locally"
        )

    def with_ramification(
        self, places: Sequence[P | str], infinite: bool | None = None
    ) -> tuple[Scalar, ...]:
        """Return constants (a, b), or (a, b, t), of an algebra that ramifies exactly at the places or their
        texts.

        Over ℚ, ``infinite`` determines whether ∞ is one of the places. Raises :class:`RingError` if this is
        not implemented for the field, or if there is no such algebra.
        """
        if infinite is not None:
            raise no_flag(self.ring)
        raise RingError(
            f"algebras are made from their ramification over number fields and GF(q)(t), not over {self.ring}"
        )

    def ramified_at_small_places(self, form: NormalForm[E]) -> tuple[P, ...]:
        """Return some places at which a form does not split, without factoring anything."""
        return ()

    # --- zeros of norm forms, and why there are none -------------------------------------------

    @abstractmethod
    def unramified_zero(self, c: Constants, form: NormalForm[E]) -> ZeroNorm:
        """Return an element of norm 0 of an algebra for which :meth:`ramified` returns no places.

        If ``splits_if_unramified``, there is one by the theorem of Hasse and Minkowski; else the answer may
        be that there is none.
        """

    def residues(self, place: P) -> FinitePlace | None:
        """Return a finite place with its residue field, as in :mod:`hfield.fields.base.finite_places`.

        None for an infinite place of a number field, and if the residue field is not finite.
        """
        return None

    def unit_and_prime(self, c: Constants, place: P) -> tuple[Vector, Vector] | None:
        """Return two quaternions that prove the norm to be anisotropic over the completion (Voight, 13.3.11).

        Return None if the norm is isotropic, or if :meth:`residues` returns None.
        """
        at = self.residues(place)
        return None if at is None else unit_and_prime(at, *self._exact(c))

    def hyperbolic_plane(self, c: Constants, place: P) -> tuple[Vector, Vector] | None:
        """Return q and u such that the norm has a zero on their span over the completion, by Hensel's lemma.

        None if the norm has no zero, or if :meth:`residues` returns None; see :mod:`local_order`.
        """
        at = self.residues(place)
        return None if at is None else hyperbolic_plane(at, *self._exact(c))

    def _exact(self, c: Constants) -> tuple[Constants, Scalar]:
        """Return the constants and 1 as numbers that the place computes with."""
        return c, self.ring.one

    def evidence(self, c: Constants, places: Iterable[P]) -> Iterator[Mapping[str, object]]:
        """Yield evidence that the checker of certificates may accept, for an algebra that ramifies at the
        places.
        """
        for place in places:
            found = self.unit_and_prime(c, place)
            if found is not None:
                u, j = ([self.ring.text(self.ring(x)) for x in v] for v in found)
                yield {"by": "place", "place": self.ring.place_data(place), "u": u, "j": j}

    # --- isomorphisms and square roots ---------------------------------------------------------

    def residue_forms(
        self, form: Sequence[E]
    ) -> Iterator[tuple[object, Ring, Sequence[Scalar], Sequence[Scalar]]]:
        """Yield places with known residue fields, and the residues of a form's coefficients there.

        The residues of coefficients of even order come first, then those of odd order, divided by a
        uniformiser. By default nothing is yielded.
        """
        return iter(())

    def is_anisotropic(self, form: Sequence[E]) -> bool | None:
        """Return whether a diagonal form with nonzero coefficients has only the zero 0; None if that is not
        decided.
        """
        return None

    def same_class(self, form: NormalForm[E], other: NormalForm[E]) -> bool:
        """Return whether two forms are isomorphic: ramified at the same places (Voight, 14.6.1)."""
        return self.ramified(form) == self.ramified(other)

    def sharing_primes(self, *forms: NormalForm[E]) -> AbstractContextManager[None]:
        """Share the primes found in one of the constants with the others, inside the ``with``."""
        numbers = [n for form in forms for x in form.constants for n in self._to_factor(x)]
        if all(-WORD < n < WORD for n in numbers):  # these are factored at once
            return nullcontext()
        return known_primes(shared_primes(numbers), "")

    def _to_factor(self, x: E) -> Iterable[int]:
        """Return the integers to be factored for finding the places at which x is not a unit."""
        return ()

    def embed(self, outer: Constants, inner: Constants) -> tuple[Coordinates, Coordinates]:
        """Return I and J in the algebra ``inner`` that satisfy the relations of ``outer``.

        Both are given by the constants of normal forms and are isomorphic; they are division algebras, if
        that helps.
        """
        raise UndecidedError(f"isomorphisms over {self.ring} are not sought")

    def traceless_root(self, form: NormalForm[E], s: E) -> Coordinates | None:
        """Return some x of trace 0 with ``x² = s`` in the basis of a form (a, b | F), or None.

        It is a division algebra, the characteristic is not 2, and s is not a square (Voight, 14.6.7).
        """
        raise UndecidedError(f"square roots of trace 0 over {self.ring} are not sought")

    def obstruction(self, form: NormalForm[E], t: E, n: E) -> P | None:
        """Return a place at which no element has trace t and norm n, for x² − t·x + n without a root; or
        None.

        It is a ramified place at which x² − t·x + n has a root. The field generated by an element with trace
        t and norm n splits the algebra; but at this place that field is F_v itself, over which the algebra is
        a division algebra.
        """
        return next((v for v in self.ramified(form) if self.has_root_at(v, t, n)), None)

    def has_root_at(self, place: P, t: E, n: E) -> bool:
        """Return whether x² − t·x + n has a root in the completion; in characteristic 2 also for t = 0."""
        local = self.ring.completion(place)
        return bool(local.is_square(local(t * t - n * self.ring(4))))

    # --- characteristic 2, where [F : F²] = 2 --------------------------------------------------

    def of_trace_one(self, form: NormalForm[E], n: E) -> Coordinates | None:
        """Return some x of trace 1 and norm n in a division algebra [a, b | F), in its basis, or None."""
        raise UndecidedError(f"elements of trace 1 over {self.ring} are not sought")

    def square_parts(self, x: E) -> tuple[E, E]:
        """Return ``(u, v)`` with ``x = u² + g·v²``, where g is the generator of the field."""
        raise UndecidedError(f"elements of {self.ring} are not split into squares here")

    def as_norm(self, x: E, s: E) -> tuple[E, E]:
        """Return ``(w, r)`` with ``x = w² + s·r²``, for an s that is not a square."""
        raise UndecidedError(f"elements of {self.ring} are not split into squares here")

    def artin_schreier(self, x: E) -> E | None:
        """Return y with ``y² + y = x``, or None."""
        raise UndecidedError(f"y² + y = x is not solved over {self.ring}")
