"""The protocol of a base ring, which every ring here and every user-defined ring satisfies.

A ring is a parent object; its elements are plain values of some library, with their own ``+``, ``-`` and
``*``. Only four members are required: ``name``, ``characteristic``, ``__call__`` and, unless ``0 == x`` is
enough, ``is_zero``. The rest has defaults that answer "not known" rather than guess.
``docs/reference/rings.md`` builds a ring from scratch.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Hashable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache, wraps
from random import Random
from typing import TYPE_CHECKING, Any, Generic, Protocol, TypeAlias, runtime_checkable

import hfield.core.flint_pickles  # noqa: F401  # so that whatever has elements of rings can be pickled
from hfield import syntax
from hfield.core.product import Constants, Scalar
from hfield.errors import (
    AbsentError,
    CoercionError,
    NotFiniteError,
    NotInvertibleError,
    RingError,
    UndecidedError,
    shorten,
)
from hfield.fields.base.foreign_values import describe
from hfield.fields.base.powers import power
from hfield.fields.base.printing import from_unicode, number_text
from hfield.fields.base.registry import REGISTRY
from hfield.fields.base.storage.base import BatchStorage, Storage

if TYPE_CHECKING:
    import numpy as np
    import sympy
    from typing_extensions import TypeVar

    E = TypeVar("E", bound=Scalar, default=Any)  # ``Ring`` alone: of elements that nobody checks
else:
    from typing import TypeVar

    E = TypeVar("E")  # an element of a ring

R = TypeVar("R", bound="Ring")
S = TypeVar("S", bound=Scalar)  # an element of another ring
T = TypeVar("T")

Embedding: TypeAlias = "Callable[[Ring, Ring[S]], Callable[[Any], S]]"
"""The map of a first ring, any one, into a second one."""

INFINITY = float("inf")
ROUNDING = 1e-9  # numbers of an inexact ring that differ by less, relatively, agree
FINITE_LIMIT = 10**9  # as in syntax.weight if values do not grow and powers take log n steps


@dataclass(frozen=True)
class Fact:
    """A fact about a ring with its reason; ``value`` is None if it is not known."""

    value: float | None
    reason: str

    def __str__(self) -> str:
        shown = {None: "not known", INFINITY: "∞"}.get(self.value, self.value)
        return f"{shown}, because {self.reason}" if self.reason else str(shown)


@runtime_checkable
class WithIntegers(Protocol):
    """ℚ and the number fields, which have a ring of integers; ``degree`` is the degree over ℚ."""

    @property
    def degree(self) -> int:
        """The degree over ℚ."""

    def integral_basis(self) -> Sequence[Scalar]:
        """Return a basis over ℤ of the ring of integers, 1 first."""


class Core(ABC, Generic[E]):
    """A commutative ring with 1: the arithmetic of its elements.

    ``name`` is the text that :func:`hfield.ring` reads back; rings of one class are equal if their names are.
    ``order`` is None for an infinite ring, ``is_field`` is None if that is not known, and ``gen_name`` is the
    name of the generator, if any.
    """

    name: str
    characteristic: int
    order: int | None = None
    is_exact: bool = True
    exact_ring: str = "RR"  # of an inexact ring: where its numbers are exact
    is_field: bool | None = None
    gen_name: str | None = None

    @abstractmethod
    def __call__(self, x: object) -> E:
        """Convert an int, a Fraction, an element or a text to an element. Raises CoercionError."""

    @property
    def zero(self) -> E:
        """The element 0."""
        return self(0)

    @property
    def one(self) -> E:
        """The element 1."""
        return self(1)

    def is_zero(self, x: E) -> bool:
        """Return whether x is 0."""
        return bool(x == self.zero)

    def equal(self, x: E, y: E) -> bool:
        """Return whether x = y."""
        return self.is_zero(x - y)

    def inverse(self, x: E) -> E:
        """Return 1/x: by default for 1 and −1, and by Python's ``/`` if the elements support it.

        Raises :class:`NotInvertibleError` if there is none, :class:`UndecidedError` if it is not known.
        """
        if self.is_zero(x):
            raise NotInvertibleError(f"cannot divide by 0 in {self.name}")
        if self.is_zero(x - self.one) or self.is_zero(x + self.one):
            return x
        found = self._quotient(x)
        if found is None:
            raise UndecidedError(
                f"whether {self.text(x)} has an inverse in {self.name} is not known: the ring has no method "
                "inverse(x), and 1/x gives none of its elements"
            )
        return found

    def _quotient(self, x: Any) -> E | None:
        """Return Python's 1/x; None if that is not an element of the ring or x·(1/x) is not 1."""
        try:
            found = self(self.one / x)
        except (TypeError, ValueError, ArithmeticError):
            return None
        return found if type(found) is type(x) and self.is_zero(found * x - self.one) else None

    def is_unit(self, x: E) -> bool:
        """Return whether x has an inverse. Raises :class:`UndecidedError` if that is not known."""
        if self.is_field and self.is_exact:
            return not self.is_zero(x)
        try:
            self.inverse(x)
        except NotInvertibleError:
            return False
        return True

    def divide(self, x: E, y: E) -> E:
        """Return x·y⁻¹."""
        return x * self.inverse(y)

    def power(self, x: E, n: int) -> E:
        """Return xⁿ by repeated squaring; for n < 0, x is inverted first."""
        return power(self.one, x if n >= 0 else self.inverse(x), abs(n))

    def annihilator(self, x: E) -> E | None:
        """Return some nonzero y with x·y = 0, or None. In a domain only 0 has such a y; in any ring, units
        have none.

        Raises :class:`UndecidedError` if it is not known.
        """
        if self.is_zero(x):
            return self.one
        if self.is_domain or self.is_unit(x):
            return None
        raise UndecidedError(
            f"whether {self.text(x)} is a zero divisor in {self.name} is not known"
        )

    @property
    def is_domain(self) -> bool:
        """Whether it is known that a product is 0 only if a factor is."""
        return bool(self.is_field)

    @property
    def no_field(self) -> str:
        """The reason why this is not a field, or not known to be one."""
        known = "not a field" if self.is_field is False else "not known to be a field"
        return f"{self.name} is {known}"

    def vanishes(self, x: E) -> bool:
        """Return whether x is 0 to its known precision: elements of local fields may be known only up to
        O(…).
        """
        return self.is_zero(x)

    def is_known(self, x: E) -> bool:
        """Return whether x is known exactly: elements of local fields may be known only up to O(…)."""
        return True

    def agree(self, x: E, y: E) -> bool:
        """Return whether x = y to their known precision; in an inexact ring, up to rounding."""
        if self.is_exact:
            return self.vanishes(x - y)
        size: Any = abs
        return bool(size(x - y) <= ROUNDING * (1 + size(x) + size(y)))

    @property
    def gen(self) -> E:
        """The generator: the class of x, the square root, the variable. Raises :class:`AbsentError`."""
        raise AbsentError(f"{self.name} has no generator")

    def text(self, x: E, style: str = "plain") -> str:
        """Write x; the ring reads ``plain`` back. Other styles are ``unicode`` and ``latex``."""
        return str(x)

    def key(self, x: E) -> Hashable:
        """Return a hashable key; equal elements have equal keys."""
        return self.text(x)

    def state(self, x: E) -> object:
        """Return plain data for x in a pickle, which the ring reads back; by default a text."""
        return self.text(x)

    def __eq__(self, other: object) -> bool:
        return type(other) is type(self) and self.name == other.name

    def __hash__(self) -> int:
        return hash(self.name)

    def __repr__(self) -> str:
        return self.name


class Named(Core[E]):
    """Reading and writing: elements as text; the ring in words, as data and in LaTeX."""

    parse_limit: int = 20_000  # the greatest syntax.weight of a text; less for many variables

    def in_words(self) -> str:
        """Return a description of the ring, such as ``rational functions in z over ℚ``; by default its
        name.
        """
        return self.name

    @property
    def data(self) -> dict[str, object] | None:
        """The ring as JSON data in certificates (docs/reference/certificates.md); None if it has no such
        form.
        """
        return None

    def names(self) -> dict[str, E]:
        """The names that this ring's texts may contain, with their values: its generators (GF(4)(t) has x and
        t).
        """
        return {} if self.gen_name is None else {self.gen_name: self.gen}

    def functions(self) -> dict[str, Callable[..., E]]:
        """The functions that this ring's texts may contain, such as ``sqrt``."""
        return {}

    def named_constants(self, node: syntax.Node) -> syntax.Node:
        """Return a tree in which each number known only to some precision is written as one call."""
        return node

    def spelled_constants(self, node: syntax.Node) -> syntax.Node:
        """Return a tree in which such calls are written in the usual notation."""
        return node

    def parse(self, text: str) -> E:
        """Read an element from text, in the grammar of :mod:`hfield.syntax`."""
        functions: dict[str, Callable[..., E]]
        functions = {"/": self.divide, "**": self.power, **self.functions()}
        reader = syntax.Reader(self, self.names(), functions, self.name, self.parse_limit)
        value: E = reader.read(from_unicode(text))
        return value

    def ratio(self, x: Fraction) -> E:
        """Return a Fraction as an element. Raises :class:`NotInvertibleError`, for instance for 1/2
        in GF(4).
        """
        try:
            return self.divide(self(x.numerator), self(x.denominator))
        except NotInvertibleError:
            raise NotInvertibleError(
                f"{shorten(number_text(x))} is not an element of {shorten(self.name)}: its denominator "
                f"has no inverse there, for the characteristic is {shorten(self.characteristic)}"
            ) from None

    def generators(self) -> dict[str, E]:
        """Return the elements that symbols of sympy stand for, by name: the generators, without names of
        numbers.
        """
        return self.names()

    def generator_of(self, polynomial: Sequence[Fraction]) -> sympy.Expr | None:
        """Return the generator in sympy if it has this minimal polynomial, low degree first; else None."""
        return None

    def function_of_symbols(self, x: sympy.Expr, read: Callable[[sympy.Expr], E]) -> E | None:
        """Return a function of symbols, such as cos(t), as an element; None if it is not in the ring."""
        return None

    def to_sympy(self, x: E, symbols: Mapping[str, sympy.Symbol]) -> sympy.Expr:
        """Return x as a sympy expression in the given symbols, or in symbols with the generators' names.

        Raises :class:`CoercionError` if sympy has no such numbers.
        """
        raise CoercionError(f"sympy has no expressions for the elements of {shorten(self.name)}")

    def refuse(self, x: object, hint: str = "") -> CoercionError:
        """Return the error for a value that is not an element of this ring."""
        called, mend = describe(x, self.name, self.is_exact, self.characteristic)
        name = shorten(self.name)
        return CoercionError(f"{shorten(called, 80)} is not an element of {name}: {hint or mend}")

    @property
    def latex_name(self) -> str:
        """The name as LaTeX mathematics."""
        from hfield.fields.base.latex_names import latex_name

        return latex_name(self.name)

    def _repr_latex_(self) -> str:
        return f"${self.latex_name}$"


class Enumerated(Core[E]):
    """The elements of a finite ring, and random elements of any ring."""

    def elements(self) -> Iterator[E]:
        """Yield all elements of a finite ring, 0 and 1 first."""
        raise NotFiniteError(f"{self.name} is infinite, so its elements cannot be listed")

    def random(self, rng: Random) -> E:
        """Return a random element, small if the ring is infinite; the same for the same seed."""
        return self(rng.randint(-9, 9))


def _of_numbers_too(
    method: Callable[[Core[E], E], T],
) -> Callable[[Core[E], E | int | Fraction | str], T]:
    """Return a method of elements that also accepts ints, Fractions and texts that the ring reads."""

    @wraps(method)
    def of_value(self: Core[E], x: E | int | Fraction | str) -> T:
        return method(self, self(x) if isinstance(x, int | Fraction | str) else x)

    return of_value


class WithSquares(Core[E]):
    """Squares, roots, orderings and the level."""

    closure: str | None = None  # "real closed" or "algebraically closed", where it is

    def __init_subclass__(cls) -> None:
        super().__init_subclass__()
        for name in ("sqrt", "is_square"):
            if name in vars(cls):
                setattr(cls, name, _of_numbers_too(vars(cls)[name]))

    @property
    def level(self) -> Fact:
        """The level s(F): the least number of squares with sum −1; ``inf`` if −1 is not a sum of squares."""
        return Fact(None, "nothing is known of the squares of this ring")

    def level_of(self, squares: Sequence[E], fewer: str = "−1 itself is not a square") -> Fact:
        """Return the level, given squares with sum −1 and the reason ``fewer`` why fewer squares do not
        suffice.
        """
        shown = " + ".join(f"({self.text(y)})^2" for y in squares)
        more = f", and {fewer}" if len(squares) > 1 else ""
        return Fact(len(squares), f"−1 = {shown} in {self.name}{more}")

    def minus_one_as_squares(self) -> tuple[E, ...]:
        """Elements, as many as the level, whose squares add up to −1; () if not known."""
        return ()

    def sqrt(self, x: E) -> E | None:
        """Return some y with y² = x, or None if there is none. Raises :class:`UndecidedError` if it is not
        known.
        """
        raise UndecidedError(f"square roots in {self.name} cannot be decided")

    def is_square(self, x: E) -> bool:
        """Return whether x is a square, even if its roots cannot be written down."""
        return self.sqrt(x) is not None

    def roots(self, coefficients: Sequence[E]) -> list[E]:
        """Return all x with Σ cₙ·xⁿ = 0, each once, for coefficients that are not all 0.

        Raises :class:`UndecidedError` if they are not computed.
        """
        raise UndecidedError(f"roots of polynomials over {self.name} are not computed")

    def irreducible_factors(self, coefficients: Sequence[E]) -> list[list[E]]:
        """Return the distinct monic irreducible factors of a nonzero polynomial over a field.

        Coefficients go from low to high. The default finds those of polynomials of degree 2, and of degree 4
        in x², by square roots. Raises :class:`UndecidedError` for others.
        """
        from hfield.fields.base.roots import by_square_roots

        return by_square_roots(self, coefficients)

    def is_rootless(self, coefficients: Sequence[E]) -> bool:
        """Return whether Σ cₙ·xⁿ certainly has no root; by default only for quadratics, by their
        discriminants.
        """
        if len(coefficients) != 3 or self.characteristic == 2 or self.is_zero(coefficients[2]):
            return False
        c, b, a = coefficients
        try:
            return self.sqrt(b * b - self(4) * a * c) is None
        except UndecidedError:
            return False

    @property
    def orderings(self) -> Fact:
        """The number of orderings of the field (0 exactly if the level is finite)."""
        if self.level.value is None:
            return Fact(None, self.level.reason)
        if self.level.value == INFINITY:
            return Fact(None, "at least one, for −1 is not a sum of squares")
        return Fact(0, f"−1 is a square or a sum of squares: {self.level.reason}")

    def sign(self, x: E, ordering: int = 0) -> int:
        """Return −1, 0 or 1: the sign of x in an ordering of the field (numbered from 0).

        Raises :class:`RingError` if there is no such ordering.
        """
        self.check_ordering(ordering)
        raise UndecidedError(f"{self.name} has no ordering that is known")

    def check_ordering(self, ordering: int) -> None:
        """Raise an error for the number of an ordering that the ring does not have."""
        known = self.orderings.value
        if ordering < 0 or (known is not None and ordering >= known):
            raise RingError(f"{self.name} has no ordering number {ordering}; there are {known}")


class WithRelatives(Core[E]):
    """Related rings: the field of fractions, residue rings, constants."""

    def euclid(self, x: E, y: E) -> tuple[E, E]:
        """Return q and r with x = q·y + r and r smaller than y ≠ 0: division in a Euclidean ring.

        Raises :class:`UndecidedError` for any other ring.
        """
        raise UndecidedError(f"{self.name} is not known to be Euclidean")

    @property
    def is_domain(self) -> bool:
        """Whether it is known that a product is 0 only if a factor is."""
        return super().is_domain or self.fractions is not None

    @property
    def fractions(self) -> Ring | None:
        """The field of fractions of an integral domain that is not a field, if that field has a name."""
        return None

    def modulo(self, n: int) -> Ring | None:
        """Return ℤ/n if this ring has exactly one homomorphism onto it, as ℤ does, and ℤ/m for n | m; else
        None.
        """
        return None

    @property
    def residues_of(self) -> tuple[Ring, Scalar] | None:
        """The Euclidean ring R and the m for which this ring is R/m; None for any other ring.

        :meth:`lift` then returns an element of R for each element of this ring.
        """
        return None

    def lift(self, x: E) -> Scalar:
        """Return a representative in R, if this ring is R/m (see :attr:`residues_of`)."""
        raise UndecidedError(f"{self.name} is not known as a ring of residues")

    @property
    def constants(self) -> Ring | None:
        """The ring k of constants of k(x) and k[x, …]; None for any other ring."""
        return None

    def as_constant(self, x: E) -> object:
        """Return x as an element of the ring of constants, or None if it is not constant."""
        return None

    def embed_from(self, source: Ring[S]) -> Callable[[S], E] | None:
        """Return the map of a ring into this one, or None if elements are to be mapped by their texts.

        Raises :class:`CoercionError` if there is no map.
        """
        return None

    def images_in(self, target: Ring[S]) -> dict[str, S]:
        """Return the images of this ring's generators in another ring, if their names do not determine them.

        Raises :class:`CoercionError` if they have no meaning there.
        """
        return {}


class WithArrays(Core[E]):
    """Arrays of elements."""

    def array(self, values: object) -> np.ndarray:
        """Convert an element, a sequence or an array to an array that computes elementwise."""
        from hfield.fields.base.arrays import objects

        return objects(values, self)

    def array_inverse(self, values: np.ndarray) -> np.ndarray:
        """Invert an array of units elementwise; the caller has checked that they are units."""
        import numpy as np

        inverses = [self.inverse(self.scalar(values[n])) for n in np.ndindex(*values.shape)]
        return self.array(inverses).reshape(values.shape)

    def array_units(self, values: np.ndarray) -> np.ndarray:
        """Return a bool array that marks the units."""
        import numpy as np

        flags = [self.is_unit(self.scalar(values[n])) for n in np.ndindex(*values.shape)]
        return np.array(flags, dtype=bool).reshape(values.shape)

    def scalar(self, x: Any) -> E:
        """Convert an entry of ``array`` back to an element."""
        element: E = x[()] if hasattr(x, "ndim") and x.ndim == 0 else x
        return element


class WithVariables(Core[E]):
    """Rings with variables: substitution and derivatives."""

    variables: tuple[str, ...] = ()

    @property
    def variable_names(self) -> tuple[str, ...]:
        """The variables for substitution and derivatives."""
        return self.variables

    @property
    def values_ring(self) -> Ring | None:
        """The ring that contains an element once every variable is replaced by a value; None without
        variables.
        """
        return None

    def images_of(self, values: Mapping[str, object], target: Ring[S]) -> dict[str, S]:
        """Return the images of the variables in the target, given values for some of them; the others stay.

        Raises :class:`CoercionError` for values that the target does not read.
        """
        own = {name: x for name, x in target.generators().items() if name in self.variable_names}
        return own | {name: target(x) for name, x in values.items()}

    def evaluation(
        self,
        target: Ring[S],
        images: Mapping[str, S],
        below: Embedding[S],
    ) -> Callable[[E], S]:
        """Return the homomorphism into a ring that maps the variables to these images.

        ``below`` returns the map of a ring of constants into another one. The homomorphism raises
        :class:`NotInvertibleError` at poles.
        """
        raise CoercionError(f"{self} has no variables")

    def derivative(self, x: E, variable: str) -> E:
        """Return the derivative of x by a variable. Raises :class:`CoercionError` for another name."""
        shown = ", ".join(self.variable_names) or "none"
        raise CoercionError(
            f"{shorten(variable)} is not a variable of {self}; its variables: {shown}"
        )

    def variables_in(self, x: E) -> set[str]:
        """Return the variables that occur in x."""
        return set()


class WithPlaces(Core[E]):
    """Fields with places, and the object that computes with them."""

    theory: str = (
        ""  # of a field with places: the name of its theory in hfield.fields.base.registry
    )

    def places(self) -> Iterator[Hashable]:
        """Yield the places of a global field, infinite ones first, without end.

        Raises :class:`UndecidedError` for any other ring.

        >>> from itertools import islice
        >>> from hfield import ring
        >>> list(islice(ring("QQ(I)").places(), 4))
        [inf, (2, 1+I), 3, (5, I-2)]
        """
        raise UndecidedError(f"{self.name} is not a global field: its places are not listed")

    def place_data(self, place: object) -> dict[str, object]:
        """Return a place of the field as JSON data. Raises :class:`RingError` for what is none."""
        if not hasattr(place, "data"):
            raise RingError(f"{shorten(place)} is not a place of {shorten(self.name)}")
        found: dict[str, object] = place.data
        return found


class Ring(
    Named[E],
    Enumerated[E],
    WithSquares[E],
    WithRelatives[E],
    WithVariables[E],
    WithArrays[E],
    WithPlaces[E],
):
    """A commutative ring with 1. Its methods answer "not known" rather than guess.

    A subclass defines ``name``, ``characteristic`` and ``__call__``, and overrides what it can compute.

    >>> from hfield import GF
    >>> isinstance(GF(9), Ring), GF(9).order, GF(9).gen_name
    (True, 9, 'x')
    """

    def foreign(self, x: object) -> E:
        """Return the element that a sympy object represents. Raises :class:`CoercionError`, also for other
        objects.
        """
        from hfield.fields.base.from_sympy import is_of_sympy, read_foreign

        if not is_of_sympy(x):
            raise self.refuse(x)
        return read_foreign(self, x)

    def closed_form(self, x: sympy.Expr) -> E:
        """Return the element that a sympy number represents if it is not a rational number, such as sqrt(2).

        Raises :class:`CoercionError` if it is not in the ring.
        """
        from hfield.fields.base.from_sympy import closed_form

        return closed_form(self, x)

    def cosine_and_sine_of(self, angle: object, parts: int = 1) -> tuple[E, E]:
        """Return the cosine and sine of an angle, such as ``"2*t + pi/3"``, divided into equal parts.

        Raises :class:`CoercionError` if the ring does not contain them.
        """
        return REGISTRY.functions.cosine_and_sine(self, angle, parts)

    def completion(self, place: object) -> Ring:
        """Return the completion of a global field at a place, or at the text of one.

        At a finite place it is a local field. At an infinite place it is RR or CC if these read the field,
        because a statement about all real numbers holds if it holds for the algebraic ones (Tarski); else ℝ
        or ℂ, whose known elements are those of the field. Raises :class:`RingError` for a place of another
        field, and :class:`UndecidedError` if there are no places.

        >>> from hfield import ring
        >>> ring("QQ").completion(5), ring("QQ(I)").completion("(5, I-2)"), ring("QQ").completion("inf")
        (Qp(5), QQ(I)_(5, I-2), RR)
        """
        return REGISTRY.completion(self, place)

    def storage(self, constants: Constants) -> Storage:
        """Return the storage of elements of the algebra with these constants; by default as tuples."""
        from hfield.fields.base.storage.plain import Plain

        return Plain(self, constants)

    def array_storage(self, constants: Constants) -> BatchStorage:
        """Return the storage of arrays of such elements: by default each entry is stored by :meth:`storage`.

        A ring whose arrays belong to a library computes with four such arrays.
        """
        if type(self).array is not WithArrays.array:
            return BatchStorage(self, constants)
        from hfield.fields.base.array_storage.object_arrays import ObjectArrays

        return ObjectArrays(self, constants)


def shared(kind: Callable[..., R], *arguments: Hashable) -> R:
    """Return a function that creates one ring for each list of arguments and returns the same one
    each time.
    """
    made: R = _shared(kind, *arguments)
    return made


@lru_cache(maxsize=1024)
def _shared(kind: Callable[..., Ring], *arguments: Hashable) -> Any:
    return kind(*arguments)
