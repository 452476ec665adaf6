"""K(x, …), K[x, …], K(cos(t), sin(t), …) over a number field K = ℚ(θ): sums Σ cₙ·θⁿ in which the cₙ do not
contain θ.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from random import Random
from typing import TYPE_CHECKING

from hfield.errors import CoercionError, NotInvertibleError, shorten
from hfield.fields.base.printing import blackboard, sum_text
from hfield.fields.base.ring import INFINITY, Embedding, Fact, Ring, S, shared
from hfield.fields.base.roots import horner, monic_root
from hfield.fields.function_fields.extensions import ElementBelow, ExtensionElement, SimpleExtension
from hfield.fields.function_fields.ring import FunctionField

if TYPE_CHECKING:
    import sympy

    from hfield.fields.number_fields.elements import FieldElement
    from hfield.fields.number_fields.ring import NumberField

Factors = list[tuple[str, int]]


class OverNumberField(SimpleExtension):
    """Rational functions or polynomials over a number field, as an extension of those over ℚ.

    ``constants`` is the number field, which reads and writes the constants.

    >>> from hfield import ring
    >>> F = ring("QQ(sqrt(2))(x)")
    >>> F("1/(x - sqrt(2))"), F("(x + sqrt(2))^2")
    (1/(x^2-2)*sqrt(2)+x/(x^2-2), 2*x*sqrt(2)+x^2+2)
    """

    def __init__(self, base: Ring, field: NumberField) -> None:
        modulus = [base(c) for c in field.modulus_over_rationals()]
        name = f"{field.name}{base.name.removeprefix('QQ')}"
        words = base.in_words().replace(blackboard("QQ"), blackboard(field.name))
        super().__init__(name, words, base, str(field.gen_name), modulus)
        self._field = field
        self.is_field = bool(base.is_field)

    def __reduce__(self) -> tuple[object, ...]:
        return shared, (type(self), self.base, self._field)

    @property
    def data(self) -> dict[str, object]:
        """The data of the ring over ℚ, with ℚ replaced by the number field."""
        assert self.base.data is not None
        return {**self.base.data, "base": self._field.data}

    @property
    def constants(self) -> Ring:
        """The number field."""
        return self._field

    @property
    def values_ring(self) -> Ring:
        """The number field."""
        return self.constants

    @property
    def is_domain(self) -> bool:
        """Yes: polynomials over a field have no zero divisors."""
        return True

    @property
    def fractions(self) -> Ring | None:
        """The rational functions over the number field, for polynomials in one variable."""
        below = None if self.is_field else self.base.fractions
        return None if below is None else shared(OverNumberField, below, self._field)

    def as_constant(self, x: ExtensionElement) -> FieldElement | None:
        """Return x as an element of the number field, or None if it is not constant."""
        found = [self.base.as_constant(c) for c in x.coefficients]
        return None if None in found else self._field.of_coefficients(found)

    def constant(self, c: FieldElement) -> ExtensionElement:
        """Return an element of the number field as a constant."""
        return ExtensionElement(self, [self.base(x) for x in self._field.coefficients_of(c)])

    def from_below(self, x: object) -> ExtensionElement:
        """Convert a number, or an element without θ, to an element. Raises :class:`CoercionError`."""
        try:
            return self.constant(self._field(x))
        except CoercionError:
            return super().from_below(x)

    def names(self) -> dict[str, ExtensionElement]:
        """The variables, and the names of numbers."""
        below = {name: self.reduced([x]) for name, x in self.base.names().items()}
        return below | {name: self.constant(x) for name, x in self._field.names().items()}

    def generators(self) -> dict[str, ExtensionElement]:
        """Return the variables, and those generators of the number field that are not numbers."""
        below = {name: self.reduced([x]) for name, x in self.base.generators().items()}
        return below | {name: self.constant(x) for name, x in self._field.generators().items()}

    def functions(self) -> dict[str, Callable[..., ExtensionElement]]:
        """The functions of the number field, applied to constants."""
        own = {name: self._of_constants(name, f) for name, f in self._field.functions().items()}
        return super().functions() | own

    def _of_constants(
        self, name: str, f: Callable[..., FieldElement]
    ) -> Callable[..., ExtensionElement]:
        def value(*arguments: ExtensionElement) -> ExtensionElement:
            constants = [self.as_constant(self(x)) for x in arguments]
            if None in constants:
                raise CoercionError(
                    f"{name} takes numbers of {self._field}, found {shorten(arguments[0])}"
                )
            return self.constant(f(*constants))

        return value

    def closed_form(self, x: sympy.Expr) -> ExtensionElement:
        """Return a number as a constant."""
        return self.constant(self._field.closed_form(x))

    # --- arithmetic ----------------------------------------------------------------------------

    def inverse(self, x: ExtensionElement) -> ExtensionElement:
        """Return 1/x. Raises :class:`NotInvertibleError` for 0, and for polynomials of positive degree."""
        if self.is_field:
            return super().inverse(x)
        c = self.as_constant(x)
        if c is None:
            raise NotInvertibleError(
                f"{shorten(self.text(x))} is not constant, so it has no inverse in {self.name}"
            )
        return self.constant(self._field.inverse(c))

    @property
    def level(self) -> Fact:
        """The level of the number field."""
        known = self._field.level
        if known.value == INFINITY:
            return Fact(INFINITY, f"{self.name} has an ordering, as {self._field.name} has one")
        return Fact(
            known.value,
            f"it is the level of {self._field.name}, for −1 is as many squares there: {known.reason}",
        )

    def minus_one_as_squares(self) -> tuple[ExtensionElement, ...]:
        """Return constants whose squares add up to −1."""
        return tuple(map(self.constant, self._field.minus_one_as_squares()))

    def sqrt(self, x: ExtensionElement) -> ExtensionElement | None:
        """Return some y with y² = x, or None.

        In several variables this is supported only for constants and for elements without θ that have such a
        root without θ; others raise :class:`UndecidedError`.
        """
        c = self.as_constant(x)
        if c is None and not isinstance(self.base, FunctionField):
            return super().sqrt(x)
        lead, root = (c, self.one) if c is not None else self.leading_and_root(x)
        number = self._field.sqrt(lead)
        return None if number is None or root is None else self.constant(number) * root

    def leading_and_root(self, x: ExtensionElement) -> tuple[FieldElement, ExtensionElement | None]:
        """Return c in K and some y with x = c·y² for functions in one variable; y is None if there
        is none.
        """
        base = self.base
        assert isinstance(base, FunctionField), "the functions have one variable"
        below = base.one.num
        for part in x.coefficients:
            below = below * (part.den // below.gcd(part.den))
        rows = [(part * base.quotient(below * below, base.one.num)).num for part in x.coefficients]
        size = max(row.degree() for row in rows)
        coefficients = [
            self._field.of_coefficients([row[k] for row in rows]) for k in range(size + 1)
        ]
        lead = coefficients[-1]
        root = monic_root(self._field, [c / lead for c in coefficients])
        if root is None:
            return lead, None
        total = self.zero
        for c in reversed(root):
            total = total * self.reduced([base.variable]) + self.constant(c)
        return lead, total * self.reduced([base.quotient(base.one.num, below)])

    def random(self, rng: Random) -> ExtensionElement:
        """Return a small random element; the same for the same seed."""
        return self.reduced([self.base.random(rng)]) + self.constant(self._field.random(rng))

    # --- values, derivatives, texts ------------------------------------------------------------

    @property
    def variable_names(self) -> tuple[str, ...]:
        """The variables; θ is a number."""
        return self.base.variable_names

    def images_of(self, values: Mapping[str, object], target: Ring[S]) -> dict[str, S]:
        """Return the images of the variables."""
        return self.base.images_of(values, target)

    def evaluation(
        self,
        target: Ring[S],
        images: Mapping[str, S],
        below: Embedding[S],
    ) -> Callable[[ExtensionElement], S]:
        """Return the homomorphism that maps the variables to these images, and constants as ``below``."""
        coefficient = self.base.evaluation(target, images, below)
        theta = self._field.gen
        same = isinstance(target, OverNumberField) and target.constants == self._field
        root = target(theta) if same else below(self._field, target)(theta)

        return lambda x: horner([*map(coefficient, x.coefficients)], root, target.zero)

    def derivative(self, x: ExtensionElement, variable: str) -> ExtensionElement:
        """Return the derivative; that of θ is 0."""
        if variable not in self.variable_names:
            return Ring.derivative(self, x, variable)
        return ExtensionElement(self, [self.base.derivative(c, variable) for c in x.coefficients])

    def variables_in(self, x: ExtensionElement) -> set[str]:
        """Return the variables in the coefficients."""
        return set().union(*map(self.base.variables_in, x.coefficients))

    def _in_monomials(self, x: ExtensionElement) -> list[tuple[ElementBelow, Sequence[int]]]:
        """Return the coefficients of x in products of powers of the numbers that generate K in its name, and
        the exponents.
        """
        rows, exponents = self._field.monomials()
        found: list[tuple[ElementBelow, Sequence[int]]] = []
        for column, powers in enumerate(exponents):
            total = self.base.zero
            for c, row in zip(x.coefficients, rows, strict=True):
                if row[column] != 0:
                    total = total + c * self.base(row[column])
            if not self.base.is_zero(total):
                found.append((total, powers))
        return found

    def text(self, x: ExtensionElement, style: str = "plain") -> str:
        """Write x in terms of the numbers in the name of K, with functions as coefficients."""
        shown = self._field.number_texts(style)
        terms = (
            (self.base.text(c, style), list(zip(shown, powers, strict=True)))
            for c, powers in reversed(self._in_monomials(x))
        )
        return sum_text(terms, style)

    def to_sympy(self, x: ExtensionElement, symbols: Mapping[str, sympy.Symbol]) -> sympy.Expr:
        """Return x as an expression in the variables and the numbers of K."""
        import sympy

        numbers = [
            self._field.to_sympy(self._field(text), symbols)
            for text in self._field.number_texts("plain")
        ]
        return sympy.Add(
            *(
                self.base.to_sympy(c, symbols)
                * sympy.Mul(*(y**n for y, n in zip(numbers, powers, strict=True)))
                for c, powers in self._in_monomials(x)
            )
        )

    def divide(self, x: ExtensionElement, y: ExtensionElement) -> ExtensionElement:
        """Return x/y; for polynomials, only if y divides x. Raises :class:`NotInvertibleError`."""
        if self.is_field or self.as_constant(y) is not None:
            return x * self.inverse(y)
        raise NotInvertibleError(
            f"whether {shorten(self.text(y))} divides {shorten(self.text(x))} in {self.name} is not tried"
        )
