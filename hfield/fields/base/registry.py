"""The registry through which rings find the theory of their places.

The theory of places is built on rings, so a ring cannot import it. Instead, :mod:`hfield.fields.provided`
registers functions when hfield is imported. Each function imports its result on first use.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Protocol

from hfield.errors import UndecidedError

if TYPE_CHECKING:
    import sympy

    from hfield.fields.base.ring import E, Ring
    from hfield.fields.quadratic_forms.global_field import GlobalField


@dataclass(frozen=True)
class Theory:
    """The theory of one kind of fields with places.

    ``arithmetic`` returns the subclass of ``GlobalField`` (hfield.fields.quadratic_forms.global_field) for
    these fields. ``completion`` completes a field at a place; it is None if completions are not implemented.
    ``read`` returns the field that a text without spaces names, or None; :func:`hfield.ring` calls it.
    """

    arithmetic: Callable[[], type[GlobalField]]
    completion: Callable[[Any, object], Ring] | None = None
    read: Callable[[str], Ring | None] | None = None


class FieldFunctions(Protocol):
    """Functions that rings need from the kinds of fields built on them."""

    def rational_functions(self, base: Ring, variable: str) -> Ring:
        """Return the field of rational functions in one variable over a field."""

    def cosine_and_sine(self, ring: Ring[E], angle: object, parts: int) -> tuple[E, E]:
        """Return the cosine and sine of an angle divided into equal parts, as elements of the ring."""

    def rational_number(self, x: sympy.Expr) -> object | None:
        """Return the rational number that an expression without symbols represents, or None."""

    def algebraic_to_sympy(self, x: object) -> sympy.Expr | None:
        """Return an element of RR or CC as an expression; None for other values."""

    def common_quadratic_field(self, *elements: object) -> Ring | None:
        """Return ℚ(√d) for sums of rational numbers and multiples of √d; None if all are rational."""


class Registry:
    """The theories of classes of rings, under the names in their attribute ``theory``, and single
    functions.
    """

    functions: FieldFunctions

    def __init__(self) -> None:
        self._theories: dict[str, Theory] = {}

    def add(self, name: str, theory: Theory) -> None:
        """Add a theory under a name. Raises ValueError if the name is taken by another theory."""
        if self._theories.get(name, theory) != theory:
            raise ValueError(f"there is another theory {name!r} already; expected a new name")
        self._theories[name] = theory

    def remove(self, name: str) -> None:
        """Remove a theory. Raises KeyError if there is none of that name."""
        del self._theories[name]

    def theory_of(self, ring: Ring) -> Theory | None:
        """Return the theory of a field with places; None for other rings."""
        return self._theories[ring.theory] if ring.theory else None

    def read(self, name: str) -> Ring | None:
        """Return the field that a text without spaces names in some theory, or None."""
        readers = (theory.read for theory in self._theories.values() if theory.read)
        return next((found for read in readers if (found := read(name)) is not None), None)

    def completion(self, ring: Ring, place: object) -> Ring:
        """Return the completion of a field at a place. Raises :class:`UndecidedError` for other rings."""
        theory = self.theory_of(ring)
        if theory is None or theory.completion is None:
            raise UndecidedError(
                f"{ring.name} is not a global field: it has no places to complete it at"
            )
        return theory.completion(ring, place)


REGISTRY = Registry()
