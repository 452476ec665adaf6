"""The arithmetic of completions: an algebra is determined by the square classes of its constants at the only
place.
"""

from __future__ import annotations

import random
from collections.abc import Hashable, Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from hfield.core.factorisation import Factors
from hfield.core.product import Constants, Coordinates, Scalar, conjugate, multiply, norm, trace
from hfield.errors import RingError, UndecidedError
from hfield.fields.base.ring import Ring
from hfield.fields.local.completion import Completion
from hfield.fields.local.field import DIGITS, LocalField
from hfield.fields.local.square_roots import hensel
from hfield.fields.local.symbol_precision import check_refinements
from hfield.fields.quadratic_forms.global_field import GlobalField, known_field
from hfield.fields.quadratic_forms.minimal_conics import Vector
from hfield.fields.quadratic_forms.norm_forms.zero_norm_answer import ZeroNorm, found
from hfield.fields.quadratic_forms.normal_forms import NormalForm, basis_of

if TYPE_CHECKING:
    from hfield.fields.base.finite_places import FinitePlace
    from hfield.fields.local.element import LocalElement

TRIES = 2_000


class CompletionArithmetic(GlobalField):
    """The arithmetic of a completion, based on the arithmetic ``below`` of the completed field."""

    ring: Completion

    def __init__(self, ring: Ring) -> None:
        super().__init__(ring)
        self.below = known_field(self.ring.global_field)

    def read_place(self, text: object) -> Hashable:
        """Return the only place, from its text or from None. Raises :class:`RingError` for another place."""
        place: Hashable = self.ring.place
        if text is not None and self.below.read_place(text) != place:
            raise RingError(f"{self.ring} has one place, {place}; {text} is not it")
        return place


class LocalArithmetic(CompletionArithmetic):
    """The arithmetic of a completion, based on that of the global field applied to representatives of square
    classes.

    A constant known up to O(πⁿ) is replaced by its value, once it is checked that the known digits determine
    its square class. All division algebras are isomorphic (Voight, *Quaternion Algebras*, theorem 13.3.11).
    """

    ring: LocalField

    # --- symbols -----------------------------------------------------------------------------------

    def hilbert_symbol(
        self, a: Scalar | str, b: Scalar | str, place: object, factors: Factors | None
    ) -> int:
        """Return the symbol; in characteristic 2 the symbol of [a, b | F), where a may be 0."""
        self.read_place(place)
        a, b = self._nonzero(a, b)
        even = self.ring.characteristic == 2
        return -1 if self._is_division(Constants(a, self.ring(even), b)) else 1

    def ramified(self, form: NormalForm) -> tuple[Hashable, ...]:
        """Return the place, or nothing."""
        c = Constants(form.a, self.ring(form.kind == "artin-schreier"), form.b)
        return (self.ring.place,) if self._is_division(c) else ()

    def _is_division(self, c: Constants) -> bool:
        """Decide for all numbers that the constants may stand for. Raises :class:`UndecidedError`."""
        if not (c.a.is_exact and c.b.is_exact):
            check_refinements(self.ring, c.a, c.b, lambda x, y: self._ramifies(x, c.t.value, y))
        return self._ramifies(*(x.value for x in c))

    def _ramifies(self, a: Scalar, t: Scalar, b: Scalar) -> bool:
        return self.below.unit_and_prime(Constants(a, t, b), self.ring.place) is not None

    def _check_classes(self, c: Constants) -> None:
        """Check that the square classes are known, so that a hyperbolic plane for one representative works
        for all.

        Raises :class:`UndecidedError`, whose message gives the number of digits needed.
        """
        F, what = self.ring, "an element of norm 0"
        if F.characteristic != 2:
            for x in (c.a, c.b):
                F.check_digits(x, F.square_digits, what)
        elif not (c.a.is_exact and c.b.is_exact):
            # y² + y takes all values in the prime ideal, and 1 + π^n is a norm for n beyond the pole of a
            if c.a.precision is not None and c.a.precision < 1:
                raise UndecidedError(
                    f"{what} depends on the digits of {c.a} up to {F.big_o(1)}: give it up to there"
                )
            F.check_digits(c.b, F.pole(c.a) + 1, what)

    def why_ramified(self, form: NormalForm, places: tuple[object, ...]) -> str:
        """Return a text with the symbol that shows the ramification."""
        a, b = (self.ring.text(x) for x in form.constants)
        symbol = f"({a}, {b})" if form.kind == "symbol" else f"[{a}, {b})"
        return f"the Hilbert symbol {symbol} over {self.ring} is −1"

    def discriminant(self, ramified: tuple[object, ...]) -> LocalElement:
        """Return a uniformiser, or 1."""
        return self.ring.uniformiser if ramified else self.ring.one

    # --- zeros of norm forms -----------------------------------------------------------------------

    def residues(self, place: object) -> FinitePlace:
        """Return the place of the global field with its residue field."""
        return self.ring.residues

    def unit_and_prime(self, c: Constants, place: object) -> tuple[Vector, Vector] | None:
        """Return u and j for the values of the constants; they prove nothing about constants with an O()."""
        if not all(x.is_exact for x in c):
            return None
        return self.below.unit_and_prime(Constants(*(x.value for x in c)), place)

    def evidence(self, c: Constants, places: Iterable[object]) -> Iterator[Mapping[str, object]]:
        """Yield u and j at the only place, whatever else showed that the norm has no zero."""
        return super().evidence(c, self.ring.places())

    def unramified_zero(self, c: Constants, form: NormalForm) -> ZeroNorm:
        """Return an element whose norm is 0 to some digits, and the plane in which Hensel's lemma finds a
        zero.
        """
        F = self.ring
        normal = Constants(form.a, F(form.kind == "artin-schreier"), form.b)
        self._check_classes(normal)
        plane = self.below.hyperbolic_plane(Constants(*(x.value for x in normal)), F.place)
        assert plane is not None, "an algebra that does not ramify splits"

        def lifted(v: Vector) -> Coordinates:
            w, x, y, z = (F(F.global_field(s)) for s in v)
            return w, x, y, z

        q, u = map(lifted, plane)
        x = root_on_plane(F, normal, q, u)
        zero = tuple(r + x * s for r, s in zip(q, u, strict=True))
        first, second = (_written(F, form.back(v)) for v in (q, u))
        reason = (
            f"with q = {first} and u = {second}, N(q + X·u) = N(q) + T·X + N(u)·X² has a root by Hensel's "
            "lemma, for the prime divides N(q)·N(u)/T²"
        )
        return found(F, c, form.back(zero), "hensel", reason)

    # --- isomorphisms and square roots ---------------------------------------------------------------

    def embed(self, outer: Constants, inner: Constants) -> tuple[Coordinates, Coordinates]:
        """Return I and J: a square root of a, and a square root of b that anticommutes with it."""
        i = self._root(inner, outer.a, basis_of(self.ring)[1:])
        # commutators with I span the elements that anticommute with it
        others = [self._turned(inner, i, v) for v in basis_of(self.ring)[1:]]
        return i, self._root(inner, outer.b, others)

    def traceless_root(self, form: NormalForm, s: LocalElement) -> Coordinates | None:
        """Return x of trace 0 with x² = s; the division algebra contains every quadratic extension."""
        return self._root(Constants(form.a, self.ring.zero, form.b), s, basis_of(self.ring)[1:])

    def _turned(self, c: Constants, i: Coordinates, v: Coordinates) -> Coordinates:
        """Return the commutator of i and v, which anticommutes with i."""
        left, right = multiply(c, i, v), multiply(c, v, i)
        w, x, y, z = (r - s for r, s in zip(left, right, strict=True))
        return w, x, y, z

    def _root(self, c: Constants, s: LocalElement, among: Sequence[Coordinates]) -> Coordinates:
        """Return a combination x of quaternions of trace 0 with ``x² = s``, to some digits."""
        F = self.ring
        if F.characteristic == 2:
            raise UndecidedError(f"isomorphisms of division algebras over {F} are not computed")
        rng = random.Random(1)
        for _ in range(TRIES):
            scalars = [
                F(rng.randint(-3, 3)) + F.random(rng) * F.uniformiser ** rng.randint(0, 1)
                for _ in among
            ]
            x = [
                sum((r * v[n] for r, v in zip(scalars, among, strict=True)), F.zero)
                for n in range(4)
            ]
            square = F.zero - norm(c, (x[0], x[1], x[2], x[3]))
            root = F.sqrt(F.divide(s, square)) if not F.vanishes(square) else None
            if root is not None:
                w, y, z, u = (root * r for r in x)
                return w, y, z, u
        raise UndecidedError(f"no square root of {s} was found in {TRIES} tries")

    # --- characteristic 2 ------------------------------------------------------------------------------

    def square_parts(self, x: LocalElement) -> tuple[LocalElement, LocalElement]:
        """Return u and v with ``x = u² + g·v²``, for an exactly known x."""
        if not x.is_exact:
            raise UndecidedError(f"{x} is split into squares only if it is known exactly")
        u, v = self.below.square_parts(x.value)
        return self.ring(u), self.ring(v)

    def as_norm(self, x: LocalElement, s: LocalElement) -> tuple[LocalElement, LocalElement]:
        """Return w and r with ``x = w² + s·r²``, for exactly known x and s."""
        if not (x.is_exact and s.is_exact):
            raise UndecidedError(f"{x} is written as a norm only if it and {s} are known exactly")
        w, r = self.below.as_norm(x.value, s.value)
        return self.ring(w), self.ring(r)


def root_on_plane(F: LocalField, c: Constants, q: Coordinates, u: Coordinates) -> LocalElement:
    """Return an X with N(q + X·u) = 0, where v(N(q)·N(u)) > 2·v(T) for T = tr(q·conj(u)) ≠ 0."""
    sizes = norm(c, q), trace(c, multiply(c, q, conjugate(c, u))), norm(c, u)
    if sizes[0].is_exact and not sizes[0].has_value:
        return F.zero
    # X = −(N(q)/T)·Y, where Y is the root near 1 of 1 − Y + (N(q)·N(u)/T²)·Y²
    K = F.global_field
    scale = sizes[0] / sizes[1]
    y = scale * sizes[2] / sizes[1]
    known = DIGITS if y.precision is None else min(DIGITS, y.precision)
    root = hensel(F, (K.one, -K.one, y.value), K.one, known)
    x: LocalElement = F.zero - scale * F.up_to(root, known)
    return x


def _written(F: LocalField, q: Coordinates) -> str:
    return "(" + ", ".join(F.text(x) for x in q) + ")"
