"""Polynomials in a central variable over a quaternion algebra, with left coefficients, and their roots.

B. Gordon and T. Motzkin, "On the zeros of polynomials over division rings", Trans. AMS 116 (1965). If f(q) =
0, then f = h·(x − q), so x² − tr(q)·x + N(q) divides norm(f). Modulo this quadratic polynomial f is a + b·x,
and a + b·q = 0 is a linear equation.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from itertools import islice
from typing import TYPE_CHECKING, ClassVar

from hfield.algebra.quaternion import Parent, Quaternion
from hfield.algebra.structure import radical
from hfield.core.product import Scalar
from hfield.errors import (
    CoercionError,
    MixedParentsError,
    NotationError,
    NotInvertibleError,
    UndecidedError,
    shorten,
)
from hfield.fields.base.from_sympy import coefficients_in, is_of_sympy
from hfield.fields.base.roots import common_divisor, quadratic_divisors
from hfield.fields.base.to_sympy import polynomial_in, symbol
from hfield.fields.linear_algebra.echelon import null_space, solution
from hfield.fields.quadratic_forms import is_division
from hfield.matrices.vocabulary import vocabulary
from hfield.polynomials.affine_spaces import of_trace_and_norm, on_spaces
from hfield.polynomials.roots import (
    MAX_LISTED_ELEMENTS,
    AffineFamily,
    Family,
    Roots,
    SingularFamily,
    matrices_of,
)
from hfield.polynomials.singular_polynomials import other_root
from hfield.symbols import coordinates_in, is_quaternion, of_coordinates
from hfield.sympy_printing import PrintedBySympy
from hfield.syntax import Reader
from hfield.verdicts import Verdict

if TYPE_CHECKING:
    import sympy

    from hfield.fields.base.ring import Ring

MAX_DEGREE = 1000
MAX_FAILED = 3_000
SUPERSCRIPTS = str.maketrans("0123456789", "⁰¹²³⁴⁵⁶⁷⁸⁹")


@dataclass(frozen=True)
class Polynomials:
    """The polynomials over an algebra in a central variable: ``P = A.polynomials("x"); P([c0, c1, c2])``."""

    algebra: Parent
    variable: str = "x"

    def __call__(self, coefficients: str | Iterable[object]) -> Polynomial:
        """Return the polynomial with these coefficients, low degree first, or the polynomial of a text."""
        if isinstance(coefficients, str):
            return self.parse(coefficients)
        if is_of_sympy(coefficients):
            return self._of_sympy(coefficients)
        if not isinstance(coefficients, Iterable):
            raise CoercionError(
                "a polynomial takes a list of coefficients, low degree first, or a text such as 'x^2 + i', "
                f"not {shorten(coefficients)}"
            )
        found = [self.algebra(c) for c in coefficients]
        while found and not found[-1]:
            found.pop()
        return Polynomial(self, tuple(found))

    def _of_sympy(self, x: object) -> Polynomial:
        """Return the polynomial whose coordinates are sympy polynomials in the variable."""
        given = coordinates_in(x) or (x, 0, 0, 0)
        rows = [coefficients_in(c, self.variable) for c in given]
        size = max(map(len, rows))
        columns = zip(*([*row, *[0] * (size - len(row))] for row in rows), strict=True)
        if is_quaternion(x):  # the algebra checks the coordinates
            return self([self.algebra(type(x)(*column)) for column in columns])
        return self([self.algebra(*column) for column in columns])

    def parse(self, text: str) -> Polynomial:
        """Read a polynomial such as ``x^2 + i*x + 1``. Raises :class:`NotationError`.

        >>> from hfield import H
        >>> H("QQ").polynomials().parse("(x - i)*(x - j)")
        x^2 + (-i - j)*x + k
        """
        A, F = self.algebra, self.algebra.ring
        if self.variable in F.names():
            raise NotationError(
                f"{self.variable} is an element of {F.name}; name the variable otherwise"
            )
        names, functions = vocabulary(A, lambda q: self([q]), _constant)
        names[self.variable] = self([0, 1])
        functions |= {"**": Polynomial.__pow__, "/": lambda f, g: f * _constant(g).inverse()}
        reader = Reader(
            lambda n: self([A.scalar(n)]), names, functions, f"polynomials over {A}", F.parse_limit
        )
        found: Polynomial = reader.read_typed(text)
        return found


@dataclass(frozen=True, eq=False)
class Polynomial(PrintedBySympy):
    """The polynomial ``coefficients[0] + coefficients[1]·x + …`` with x central and a nonzero last
    coefficient.

    >>> from hfield import H
    >>> A = H("QQ"); e, i, j, k = A.basis
    >>> f = A.polynomials("x")([1, 0, 1])
    >>> f, f(i), f.roots().spheres
    (x^2 + 1, 0, ((0, 1),))
    """

    parent: Polynomials
    coefficients: tuple[Quaternion, ...]

    multiplied_by_elements: ClassVar[bool] = True  # q·f and q + f are this class's
    added_to_elements: ClassVar[bool] = True

    @property
    def degree(self) -> int:
        """The degree; −1 for the zero polynomial."""
        return len(self.coefficients) - 1

    def __bool__(self) -> bool:
        return bool(self.coefficients)

    def __eq__(self, other: object) -> bool:
        if isinstance(other, Polynomial):
            return (self.parent, self.coefficients) == (other.parent, other.coefficients)
        return self.degree < 1 and bool(self(0) == other)

    def __hash__(self) -> int:
        return hash(self(0)) if self.degree < 1 else hash((self.parent, self.coefficients))

    def __call__(self, q: object) -> Quaternion:
        """Return Σ cₙ·qⁿ."""
        value, x = self.parent.algebra.scalar(0), self.parent.algebra(q)
        for c in reversed(self.coefficients):
            value = value * x + c
        return value

    def _operand(self, other: object) -> Polynomial:
        if not isinstance(other, Polynomial):
            return self.parent([other])
        if other.parent != self.parent:
            raise MixedParentsError(
                f"a polynomial over {self.parent.algebra} cannot be combined with one over "
                f"{other.parent.algebra}"
            )
        return other

    def __add__(self, other: object) -> Polynomial:
        one, two = self.coefficients, self._operand(other).coefficients
        if len(one) < len(two):
            one, two = two, one
        return self.parent([*(a + b for a, b in zip(one, two, strict=False)), *one[len(two) :]])

    __radd__ = __add__

    def __neg__(self) -> Polynomial:
        return Polynomial(self.parent, tuple(-c for c in self.coefficients))

    def __sub__(self, other: object) -> Polynomial:
        return self + -self._operand(other)

    def __rsub__(self, other: object) -> Polynomial:
        return self._operand(other) - self

    def __mul__(self, other: object) -> Polynomial:
        other = self._operand(other)
        out = [self.parent.algebra.scalar(0)] * (len(self.coefficients) + len(other.coefficients))
        for m, a in enumerate(self.coefficients):
            for n, b in enumerate(other.coefficients):
                out[m + n] = out[m + n] + a * b
        return self.parent(out)

    def __rmul__(self, other: object) -> Polynomial:
        return self._operand(other) * self

    def __pow__(self, n: int) -> Polynomial:
        if not isinstance(n, int) or n < 0 or (n > 1 and n * self.degree > MAX_DEGREE):
            raise CoercionError(
                f"a power has an exponent from 0 to {MAX_DEGREE} over the degree, not {shorten(n)}"
            )
        result = self.parent([1])
        for _ in range(n):
            result = result * self
        return result

    def conjugate(self) -> Polynomial:
        """Return the polynomial of the conjugates."""
        return self.parent([c.conjugate() for c in self.coefficients])

    def norm(self) -> Polynomial:
        """Return f·conj(f), whose coefficients lie in the base ring; it is multiplicative."""
        return self * self.conjugate()

    def divmod_right(self, other: object) -> tuple[Polynomial, Polynomial]:
        """Return h and r with f = h·g + r and deg r < deg g. The remainder by x − q is f(q).

        Raises :class:`NotInvertibleError` unless the leading coefficient of g is a unit.
        """
        return self._divided(other, left=False)

    def divmod_left(self, other: object) -> tuple[Polynomial, Polynomial]:
        """Return h and r with f = g·h + r and deg r < deg g; see :meth:`divmod_right`."""
        return self._divided(other, left=True)

    def _divided(self, other: object, left: bool) -> tuple[Polynomial, Polynomial]:
        g = self._operand(other).coefficients
        if not g:
            raise NotInvertibleError("cannot divide by the polynomial 0")
        back, rest = g[-1].inverse(), list(self.coefficients)
        quotient = [self.parent.algebra.scalar(0)] * max(len(rest) - len(g) + 1, 0)
        for shift in reversed(range(len(quotient))):
            top = rest[shift + len(g) - 1]
            c = quotient[shift] = back * top if left else top * back
            for n, b in enumerate(g):
                rest[shift + n] = rest[shift + n] - (b * c if left else c * b)
        return self.parent(quotient), self.parent(rest[: len(g) - 1])

    def gcd_right(self, other: object) -> Polynomial:
        """Return the greatest common right divisor, the monic g with A[x]·f + A[x]·other = A[x]·g, or 0.

        Raises :class:`NotInvertibleError` if the leading coefficient of a remainder is not a unit.
        """
        return self._euclid(other, left=False)[0]

    def gcd_left(self, other: object) -> Polynomial:
        """Return the monic greatest common left divisor; see :meth:`gcd_right`."""
        return self._euclid(other, left=True)[0]

    def lcm_left(self, other: object) -> Polynomial:
        """Return the least common left multiple: the monic m of least degree of the form h·f = h′·other.

        Raises :class:`NotInvertibleError` as :meth:`gcd_right` does, and for 0.
        """
        return self._euclid(other, left=False)[1]

    def lcm_right(self, other: object) -> Polynomial:
        """Return the monic least common right multiple, f·h = other·h′; see :meth:`lcm_left`."""
        return self._euclid(other, left=True)[1]

    def _euclid(self, other: object, left: bool) -> tuple[Polynomial, Polynomial]:
        """Return gcd and lcm on one side; if a remainder s·f + t·other is 0, then s·f is a common
        multiple.
        """
        P, f, g = self.parent, self, self._operand(other)
        s, u = P([1]), P([])
        while g:
            h, r = f._divided(g, left)
            f, g, s, u = g, r, u, s - (u * h if left else h * u)
        multiple = self * u if left else u * self
        return f._monic(left), multiple._monic(left)

    def _monic(self, left: bool) -> Polynomial:
        if not self:
            return self
        back = self.parent([self.coefficients[-1].inverse()])
        return self * back if left else back * self

    def text(self, style: str = "plain") -> str:
        """Write f, high degree first, in the style ``plain`` (which can be read back), ``unicode`` or
        ``latex``.
        """
        x, out = self.parent.variable, ""
        for n, c in reversed(list(enumerate(self.coefficients))):
            if not c:
                continue
            term, power = c.text(style), ("", x)[n] if n < 2 else _power(x, n, style)
            sign = " - " if _is_negative(term) else " + "
            if sign == " - ":
                term = term[1:].lstrip()
            elif power and re.search(r"(?<=.)[-+−/ ]", term):
                term = rf"\left({term}\right)" if style == "latex" else f"({term})"
            if power:
                dot = {"plain": "*", "unicode": "·"}.get(style, " ")
                term = power if term == "1" else f"{term}{dot}{power}"
            out = out + sign + term if out else sign.strip().replace("+", "") + term
        return out or "0"

    def _in_sympy(self, symbols: Mapping[str, sympy.Symbol]) -> sympy.Quaternion | sympy.Matrix:
        """Return an element with polynomials as coordinates, as :func:`hfield.to_sympy` does."""
        A, x = self.parent.algebra, symbol(self.parent.variable, symbols)
        columns = [[A.ring.to_sympy(c, symbols) for c in q.coordinates] for q in self.coefficients]
        rows = [polynomial_in(x, (column[n] for column in columns)) for n in range(4)]
        return of_coordinates(A.ring, A.constants, rows)

    def _sympy_(self) -> sympy.Quaternion | sympy.Matrix:
        return self._in_sympy({})

    def __str__(self) -> str:
        return self.text()

    __repr__ = __str__

    def _repr_latex_(self) -> str:
        return f"${self.text('latex')}$"

    # --- roots ---------------------------------------------------------------------------------

    def roots(self) -> Roots:
        """Return all q in the algebra with f(q) = 0, over a field.

        S(t, n) is the set of all q with q² = t·q − n. For each (t, n) in ``spheres`` all of S(t, n) are
        roots; ``isolated`` are roots that are the only ones in their S(t, n); ``families`` are the others, by
        trace and norm. If norm(f) = 0 and there are zero divisors modulo the radical, the others are one
        family. ``scalars`` are the roots in the base field, including those in spheres; ``count()`` and
        ``elements()`` count and list all.

        Raises :class:`CoercionError` for f = 0. Raises :class:`UndecidedError` if norm(f) is not factored,
        over rings that are not fields, and, if norm(f) = 0 and there are zero divisors modulo the radical,
        for an infinite algebra with nonzero radical.
        """
        A = self.parent.algebra
        F = A.ring
        if not self:
            raise CoercionError("every element is a root of 0")
        if not F.is_field:
            raise UndecidedError(f"{F.no_field}: roots are found over fields only")
        norm = self._base_norm() or self._in_socle()._base_norm()
        if not norm:
            return self._singular_roots()
        divisors = list(quadratic_divisors(F, norm))
        spheres, isolated, families = [], list[Quaternion](), list[Family]()
        for t, n in divisors:
            rest = self.divmod_right(self.parent([n, -t, 1]))[1].coefficients
            a, b = (*rest, *[A.scalar(0)] * (2 - len(rest)))
            if not rest and of_trace_and_norm(A, t, n) is not None:
                spheres.append((t, n))
            elif not rest:  # scalars at most: both halves of t, or the root of n where 2 = 0
                isolated += map(A.scalar, _double_root(F, t, n))
            else:
                points, directions = on_spaces(A, a, b, t, n)
                if points and (directions or len(points) > 1):
                    shown = tuple(points), tuple(directions)
                    families.append(AffineFamily(t, n, points[0], self, *shown))
                else:
                    isolated += points
        # A scalar r in no family can still lie in the sphere of (x - r)(x - s), which is not of its trace.
        alone = (q for q in isolated if not self._on_spheres(q, spheres))
        # (x - r)² divides norm(f) for a root r
        scalars = (A.scalar(r) for t, n in divisors for r in _double_root(F, t, n))
        own = tuple(r for r in scalars if not self(r))
        return Roots(tuple(spheres), tuple(alone), tuple(families), own, self)

    def _on_spheres(self, q: Quaternion, spheres: Iterable[tuple[Scalar, Scalar]]) -> bool:
        """Return whether q lies on one of the spheres: q² = t·q − n."""
        return any(not self.parent([n, -t, 1])(q) for t, n in spheres)

    def _base_norm(self) -> list[Scalar]:
        """Return the coefficients of the norm in the base ring."""
        return [c.coordinates[0] for c in self.norm().coefficients]

    def _in_socle(self) -> Polynomial:
        """Return g such that norm(q) divides norm(g) for all roots q, if coefficients lie in the radical R.

        Some y·f ≠ 0 has coefficients that R annihilates. If A/R is a field, these are multiples g·s of one of
        them; s·q is q′·s with q′ of the trace and norm of q, and g(q′) is in R, along which the norm is
        constant. If A/R has zero divisors, and if R = 0, norm(g) may be 0.
        """
        A, F, f = self.parent.algebra, self.parent.algebra.ring, self
        basis = [A(*q) for q in radical(F, A.constants)]
        if not basis:
            return self
        multiples = [self]
        while multiples:
            f = multiples[0]
            multiples = [g for g in (self.parent([r]) * f for r in basis) if g]
        annihilated = null_space(F, [list(row) for r in basis for row in r.matrix()], 4)
        right = [list(row) for row in zip(*(c.coordinates for c in f.coefficients), strict=True)]
        for s in annihilated:
            times_s = zip(*((u * A(*s)).coordinates for u in A.basis), strict=True)
            rows = [list(row) for row in times_s]
            if len(null_space(F, rows, 4)) == len(basis):  # only R annihilates s
                found = solution(F, rows, right)
                assert found is not None, "the coefficients are multiples of s"
                return self.parent(A(*q) for q in zip(*found, strict=True))
        return self

    def _singular_roots(self) -> Roots:
        """Return the roots if norm(f) = 0 and the algebra has zero divisors modulo its radical."""
        A = self.parent.algebra
        F = A.ring
        content: list[Scalar] = []
        for n in range(4):
            content = common_divisor(F, content, [c.coordinates[n] for c in self.coefficients])
        scalars = tuple(A.scalar(-g[0]) for g in F.irreducible_factors(content) if len(g) == 2)
        spheres = tuple(
            (t, n)
            for t, n in quadratic_divisors(F, content)
            if of_trace_and_norm(A, t, n) is not None
        )
        found = matrices_of(self)
        if found is not None:
            matrices, coefficients = found
            root = other_root(F, coefficients, spheres)
            example = None if root is None else A(*matrices.from_matrix(root))
        elif F.order is not None and F.order**4 <= MAX_LISTED_ELEMENTS:
            family = SingularFamily(None, None, A.scalar(0), self, spheres)
            example = next(family.elements(), None)
        else:
            raise UndecidedError(
                f"norm(f) = 0, and {A} has a radical and zero divisors modulo it: its roots are not sought"
            )
        if example is None:
            return Roots(spheres, (), (), scalars, self)
        family = SingularFamily(None, None, example, self, spheres)
        if F.order is not None and len(list(islice(family.elements(), 2))) == 1:
            alone = () if self._on_spheres(example, spheres) else (example,)
            return Roots(spheres, alone, (), scalars, self)
        return Roots(spheres, (), (family,), scalars, self)

    def linear_factors(self) -> tuple[Quaternion, tuple[Quaternion, ...]] | Verdict[None]:
        """Return (c, (q₁, …, qₙ)) with f = c·(x − q₁)⋯(x − qₙ), or a false answer if there are no such
        factors.

        Over a division algebra any root may be the last factor: factors are unique up to similarity and order
        (O. Ore, Annals of Math. 34 (1933)). Over split algebras all roots are tried, if there are finitely
        many, as over GF(q), q ≤ 17. Raises :class:`NotInvertibleError` unless c is a unit, and
        :class:`UndecidedError` if roots are not found, or there are too many to try.
        """
        A = self.parent.algebra
        if not self:
            raise NotInvertibleError(
                "0 is not a product of linear factors: its leading coefficient is not a unit"
            )
        c = self.coefficients[-1]
        c.inverse()
        search = Factoring(A, is_division(A.ring, A.constants))
        factors = search.factors(self)
        if factors is not None:
            return c, factors
        if search.is_whole:
            each = "" if search.division else ", as after every other choice of roots"
            return Verdict(
                False,
                f"{search.rest} has no root in {A}, and f is its product with linear factors{each}",
            )
        raise UndecidedError("of some roots one in a family or sphere was tried, and others may do")


class Factoring:
    """A search for linear factors: any root over a division algebra, otherwise all roots or one of each
    kind.
    """

    def __init__(self, A: Parent, division: bool) -> None:
        self.algebra, self.division, self.is_whole = A, division, True
        self.rest: Polynomial | None = None
        self.failed: set[Polynomial] = set()
        order = A.ring.order
        self.is_finite = not division and order is not None and order**4 <= MAX_LISTED_ELEMENTS

    def factors(self, f: Polynomial) -> tuple[Quaternion, ...] | None:
        """Return (q₁, …, qₙ) with f = c·(x − q₁)⋯(x − qₙ), or None if none is found."""
        if f.degree == 0:
            return ()
        if f in self.failed:
            return None
        found = f.roots()
        self.is_whole &= self.division or self.is_finite or not (found.spheres or found.families)
        if not found:
            self.rest = f
        for q in self.roots(f, found):
            before = self.factors(f.divmod_right(f.parent([-q, 1]))[0])
            if before is not None:
                return (*before, q)
            if self.division:
                break
        self.failed.add(f)
        if len(self.failed) > MAX_FAILED:
            raise UndecidedError(f"{MAX_FAILED} products of linear factors were tried")
        return None

    def roots(self, f: Polynomial, found: Roots) -> Iterator[Quaternion]:
        """Yield roots: first one of each kind, then, in a finite algebra, all others."""
        yield from _some(self.algebra, found)
        if self.is_finite:
            yield from found.elements()


def _double_root(F: Ring, t: Scalar, n: Scalar) -> list[Scalar]:
    """Return the r with x² − t·x + n = (x − r)², one or none."""
    if F.characteristic != 2:
        half = F.divide(t, F(2))
        return [half] if F.equal(half * half, n) else []
    root = F.sqrt(n) if F.is_zero(t) else None
    return [] if root is None else [root]


def _power(x: str, n: int, style: str) -> str:
    if style == "unicode":
        return x + str(n).translate(SUPERSCRIPTS)
    return f"{x}^{{{n}}}" if style == "latex" else f"{x}^{n}"


def _is_negative(term: str) -> bool:
    """Return whether a term has a leading minus."""
    return term[:1] in "-−" and not re.search(r"[-+−]", term[1:])


def _constant(f: Polynomial) -> Quaternion:
    if f.degree > 0:
        raise NotationError(
            f"{f} is a polynomial, where an element is expected, as a divisor or in a function"
        )
    return f(0)


def _some(A: Parent, found: Roots) -> Iterator[Quaternion]:
    yield from found.isolated
    yield from (r for r in found.scalars if r not in found.isolated)
    for t, n in found.spheres:
        point = of_trace_and_norm(A, t, n)
        assert point is not None
        yield point
    yield from (family.example for family in found.families)
