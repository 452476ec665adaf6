"""RR and CC: the real and the complex algebraic numbers, exact, and other numbers that can be tested for 0.

Sums of square roots are :class:`Surd` numbers. All others (roots of higher degree, nested roots, cosines, π)
are :class:`Closed` forms, given by sympy expressions; sympy is imported with the first of them.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from random import Random
from typing import TYPE_CHECKING

import flint

from hfield import syntax
from hfield.core.product import Scalar
from hfield.errors import CoercionError, NotInvertibleError, shorten
from hfield.fields.algebraic.radicals import FUNCTIONS, ROOTS
from hfield.fields.algebraic.surds import Surd, from_rational
from hfield.fields.base.coercion import rational, unwrap
from hfield.fields.base.printing import from_unicode
from hfield.fields.base.ring import INFINITY, Fact
from hfield.fields.base.roots import irreducible_factors
from hfield.fields.base.value_ring import ValueRing

if TYPE_CHECKING:
    import sympy

    from hfield.fields.algebraic.closed_forms import Closed


_I = Surd({-1: flint.fmpq(1)})

MAX_OPERATIONS = 24  # of a root in radicals; longer roots are numbered


class AlgebraicNumbers(ValueRing):
    """The algebraic numbers, real or complex. Elements are ``Surd`` or ``Closed``, both hashable.

    >>> RR("1/(sqrt(2)-1)")
    1+sqrt(2)
    >>> RR("sqrt(2)+sqrt(3)") == RR("sqrt(5+2*sqrt(6))")
    True
    """

    characteristic = 0
    is_field = True

    def __init__(self, name: str) -> None:
        self.name = name
        self.is_real = name == "RR"
        self.gen_name = None if self.is_real else "I"
        self.closure = "real closed" if self.is_real else "algebraically closed"

    def __reduce__(self) -> str:
        return self.name

    def in_words(self) -> str:
        """Return a description of the field."""
        return f"the {'real' if self.is_real else 'complex'} algebraic numbers"

    @property
    def data(self) -> dict[str, object]:
        """The kind of the field, as JSON data."""
        return {"kind": "reals" if self.is_real else "complexes"}

    @property
    def gen(self) -> Surd | Closed:
        """The imaginary unit of CC; RR has no generator."""
        return super().gen if self.is_real else _I

    def names(self) -> dict[str, Surd | Closed]:
        """The number π and, in CC, the imaginary unit I."""
        from hfield.fields.algebraic.closed_forms import PI

        return {"pi": PI} if self.is_real else {"I": _I, "pi": PI}

    def functions(self) -> dict[str, Callable[..., Surd | Closed | None]]:
        """``sqrt``, ``cbrt``, ``root(x, n)``, and ``cos sin tan cosh sinh tanh exp log``."""
        from hfield.fields.algebraic import closed_forms as closed

        return {
            "sqrt": lambda x: CC.sqrt(x),
            "cbrt": lambda x: self._root(x, 3),
            "root": self._root,
            **{name: closed.function(name) for name in FUNCTIONS},
            **{name: partial(_root_by_number, name) for name in ROOTS},
        }

    def parse(self, text: str) -> Surd | Closed:
        """Read a number; in RR too, intermediate values may be complex."""
        names = {"I": _I, **self.names()}
        functions = {"/": self.divide, "**": self.power, **self.functions()}
        reader: syntax.Reader  # the sum of two elements may be of another class
        reader = syntax.Reader(CC, names, functions, self.name, self.parse_limit)
        return self(reader.read(from_unicode(text)))

    def __call__(self, x: object) -> Surd | Closed:
        """Convert a rational number, a surd, a closed form or a sympy number to an element; read a text.

        Raises :class:`CoercionError` for a value that is not in the field, and :class:`UndecidedError` for a
        transcendental number that cannot be tested for 0.
        """
        x = unwrap(x)
        if isinstance(x, str):
            return self.parse(x)
        x = _surd_of(x) or x
        if isinstance(x, Surd):
            if self.is_real and not x.is_real():
                raise self.refuse(x, "it is not real; CC has it")
            return x
        number = rational(x)
        if number is not None:
            return from_rational(number)
        if type(x).__module__.startswith("hfield.fields.algebraic."):
            from hfield.fields.algebraic import closed_forms as closed

            if x is closed.PI:
                return x
            if isinstance(x, closed.Closed):
                if self.is_real and not x.is_real():
                    raise self.refuse(x, "it is not real; CC has it")
                # A transcendental number is accepted if it can be tested for 0.
                return from_rational(0) if x.bounds is None and x.is_zero() else x
        value: Surd | Closed = self.foreign(x)
        return value

    def generators(self) -> dict[str, Surd | Closed]:
        """Return nothing: all names stand for numbers."""
        return {}

    def closed_form(self, x: sympy.Expr) -> Surd | Closed:
        """Return the number that a sympy expression without symbols represents."""
        from hfield.fields.algebraic.closed_forms import from_sympy

        value = from_sympy(x)
        if value is None:
            raise self.refuse(x)
        return self(value)

    def to_sympy(self, x: Surd | Closed, symbols: Mapping[str, sympy.Symbol]) -> sympy.Expr:
        """Return the number as a sympy expression."""
        from hfield.fields.algebraic.closed_forms import to_sympy

        found = to_sympy(x)
        assert found is not None, "x is a number"
        return found

    def is_zero(self, x: Surd | Closed) -> bool:
        """Return whether x is 0. Raises :class:`UndecidedError` for some transcendental numbers."""
        return not x.terms if isinstance(x, Surd) else x.is_zero()

    def inverse(self, x: Surd | Closed) -> Surd | Closed:
        """Return 1/x. Raises :class:`NotInvertibleError` for 0."""
        if self.is_zero(x):
            raise NotInvertibleError(f"cannot divide by 0 in {self.name}")
        return x.inverse()

    def sqrt(self, x: Surd | Closed) -> Surd | Closed | None:
        """Return the principal root; None for x < 0 in RR."""
        if self.is_real and self.sign(x) < 0:
            return None
        root = x.sqrt() if isinstance(x, Surd) else None
        if root is not None:
            return root
        from hfield.fields.algebraic.closed_forms import root as closed_root

        return closed_root(x, 2)

    def is_square(self, x: Surd | Closed) -> bool:
        """Return whether x is a square; in RR, whether it is not negative. No root is computed."""
        return not self.is_real or self.sign(x) >= 0

    def _root(self, x: Surd, n: Scalar) -> Surd | Closed:
        """Return the n-th root: if a real number has real n-th roots, the real one, the positive one of two.

        For all other numbers it is the principal root. So a text stands for the same number in RR and in CC.
        """
        if isinstance(n, Surd) and n.terms.keys() <= {1}:
            n = n.terms.get(1, 0)
        degree = None if isinstance(n, Surd) else rational(n)
        if not isinstance(degree, int) or not 1 <= degree <= 64:
            raise CoercionError(f"root(x, n) takes an integer n from 1 to 64, not {shorten(n)}")
        from hfield.fields.algebraic.closed_forms import root

        negative = degree % 2 == 1 and not x.ball(64).real > 0 and x.is_real() and RR.sign(x) < 0
        return -root(-x, degree) if negative else root(x, degree)

    def irreducible_factors(
        self, coefficients: Sequence[Surd | Closed]
    ) -> list[list[Surd | Closed]]:
        """Return the distinct monic irreducible factors of a nonzero polynomial.

        If all coefficients are rational, all factors are found; their roots are radicals or cosines if these
        are short, else roots given by number (``rootof``). Otherwise as in
        :meth:`hfield.fields.base.ring.Ring.irreducible_factors`. Raises :class:`UndecidedError` for the rest.
        """
        rationals = [
            x.terms.get(1, flint.fmpq(0))
            for x in coefficients
            if isinstance(x, Surd) and set(x.terms) <= {1}
        ]
        if len(rationals) < len(coefficients):
            return super().irreducible_factors(coefficients)
        out: list[list[Surd | Closed]] = []
        for g in irreducible_factors(rationals):
            c = [self(x) for x in g.coeffs()]
            short = len(c) < 4 or (len(c) == 5 and g[1] == g[3] == 0)
            out += super().irreducible_factors(c) if short else self._of_radicals(g)
        return out

    def _of_radicals(self, g: flint.fmpq_poly) -> list[list[Surd | Closed]]:
        """Return the factors of an irreducible polynomial over ℚ of degree above 2, computed from its roots
        in CC.
        """
        from hfield.fields.algebraic.conjugate_pairs import factors

        roots = list(map(CC, _roots_in_radicals(g)))
        closed = [z for z in roots if not isinstance(z, Surd)]
        if closed or not roots:
            return factors(g, self.is_real, closed)
        if not self.is_real:
            return [[-z, CC.one] for z in roots]
        real = [z for z in roots if z.is_real()]
        pairs = [
            next(
                (z + w, z * w)
                for w in roots
                if w not in real and (z + w).is_real() and (z * w).is_real()
            )
            for z in roots
            if z not in real and z.ball(64).imag > 0
        ]
        linear: list[list[Surd | Closed]] = [[-RR(z), RR.one] for z in real]
        return linear + [[RR(n), -RR(t), RR.one] for t, n in pairs]

    @property
    def level(self) -> Fact:
        """∞ in RR, where −1 is not a sum of squares; 1 in CC."""
        if self.is_real:
            return Fact(INFINITY, "squares of real numbers are not negative")
        return Fact(1, "−1 = I^2")

    def minus_one_as_squares(self) -> tuple[Surd | Closed, ...]:
        """Return (I,) in CC, () in RR."""
        return () if self.is_real else (_I,)

    @property
    def orderings(self) -> Fact:
        """One in RR, because the positive numbers are the squares; none in CC."""
        if self.is_real:
            return Fact(1, "the positive numbers are the squares")
        return super().orderings

    def sign(self, x: Surd | Closed, ordering: int = 0) -> int:
        """Return −1, 0 or 1, in RR. Raises :class:`UndecidedError` as :meth:`is_zero` does."""
        if not self.is_real:
            return super().sign(x, ordering)
        self.check_ordering(ordering)
        return int(x.sign())

    def random(self, rng: Random) -> Surd | Closed:
        """Return a small random number of ℚ(√2, √3), with I in CC; the same for the same seed."""
        roots = (1, 2, 3) if self.is_real else (1, 2, -1, -3)
        terms = {n: flint.fmpq(rng.randint(-9, 9), rng.choice((1, 1, 2))) for n in roots}
        return Surd({n: c for n, c in terms.items() if c != 0})

    def text(self, x: Surd | Closed, style: str = "plain") -> str:
        """Write x, such as ``1/2+3*sqrt(2)`` or ``I*root(2,3)``."""
        return str(x.text(style))


def _surd_of(x: object) -> Surd | None:
    """Return an element of a quadratic field as a surd; None for anything else."""
    convert = getattr(x, "as_surd", None)
    found: Surd | None = convert() if convert else None
    return found


def _root_by_number(name: str, *arguments: Surd | Closed) -> Surd | Closed:
    from hfield.fields.algebraic.in_fields import root_by_number  # which imports sympy

    return root_by_number(name, *arguments)


def _roots_in_radicals(g: flint.fmpq_poly) -> list[sympy.Expr]:
    """Return the roots in radicals that sympy finds for an irreducible polynomial over ℚ, if they
    are short.
    """
    import sympy

    order = (g.numer() if g.denom() == 1 else flint.fmpz_poly([2])).is_cyclotomic()
    if order:
        turns = (2 * sympy.pi * k / order for k in range(order) if math.gcd(k, order) == 1)
        return [sympy.cos(turn) + sympy.I * sympy.sin(turn) for turn in turns]
    rationals = [sympy.Rational(int(c.p), int(c.q)) for c in reversed(g.coeffs())]
    roots = list(map(sympy.sqrtdenest, sympy.roots(sympy.Poly(rationals, sympy.Symbol("x")))))
    return roots if all(z.count_ops() <= MAX_OPERATIONS for z in roots) else []


RR = AlgebraicNumbers("RR")
CC = AlgebraicNumbers("CC")
