"""Quadratic orders inside an order of a totally definite algebra, and elements of given norm.

Let R be the integers of the base. The elements of trace 0 in R + 2O are s = 2x − tr(x) for x in O, and s² is
the discriminant of R[x]. So the quadratic orders of discriminant d in O correspond to the vectors of norm −d
in a ternary lattice. The embedding is optimal if c·s lies in this lattice only for c in R (J. Voight,
*Quaternion Algebras*, chapter 30; B. Gross, "Heights and the special values of L-series", 1987).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator
from contextlib import suppress
from dataclasses import dataclass, field
from fractions import Fraction
from itertools import count, product
from random import Random
from typing import TYPE_CHECKING

from flint import fmpq, fmpq_mat, fmpz_mat

from hfield.core.factorisation import remove
from hfield.core.properties import cached_property
from hfield.errors import IndefiniteError, LatticeError, TooLargeError, UndecidedError, shorten
from hfield.evidence import CertifiedClaim
from hfield.fields.number_fields.elements import FieldElement
from hfield.fields.number_fields.ideals import FractionalIdeal as NumberFieldIdeal
from hfield.fields.number_fields.prime_ideals import PrimeIdeal
from hfield.fields.rationals.whole_numbers import fraction, square_root
from hfield.orders import certificates, enumeration, hermite
from hfield.orders.base_values import BaseNumber, Prime
from hfield.orders.ideals_of_norm import (
    is_maximal_or_eichler,
    number_maximal,
    of_prime_norm,
    of_prime_power_norm,
    random_ideal,
    two_sided_prime,
)
from hfield.orders.invariants import is_eichler
from hfield.orders.lattice_values import LatticeValue, conjugate, discriminant, meet
from hfield.orders.lattice_values import product as product_of_lattices
from hfield.orders.norm_search import SMALL_VOLUME, of_norm, volume
from hfield.orders.orders_at_primes import OrderAtPrime
from hfield.orders.quadratic_frames import frame
from hfield.orders.represent_integer import TRIALS as TRIALS_IN_FRAME
from hfield.orders.represent_integer import element_of_large_norm
from hfield.orders.short_elements import (
    expect_definite,
    form_of_norm,
    reduced,
    rows_of_norm,
    ternary_rows,
)
from hfield.orders.units import units_modulo_scalars
from hfield.orders.validation import checked_side, listed
from hfield.verdicts import Verdict

if TYPE_CHECKING:
    from hfield.algebra.quaternion import Quaternion
    from hfield.orders.basis import AlgebraBasis
    from hfield.orders.lattice import Ideal, Order

MAX_ENUMERATED = 2 * 10**5
"""Norms are decided by enumeration where about so many steps do it."""
TRIALS = 100
"""So many random ideals are tried."""
MAX_LOCAL_IDEALS = 1_000
"""Of a prime power norm no more ideals of a maximal order are run through for those of an order in it."""
MAX_CLASSES = 20_000
"""No more classes of elements modulo powers of a prime than this are tried for a local obstruction."""


# --- embeddings ------------------------------------------------------------------------------------


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class Embeddings(Verdict["Quaternion"]):
    """The optimal embeddings of a quadratic order S of ``discriminant`` d in an order; false if there are
    none.

    Each embedding is given by the image of ``(t + √d)/2`` with t² ≡ d modulo 4; over ℤ, t = d. ``reason``
    explains why there is none.
    """

    order: Order
    discriminant: object
    listed: tuple[Quaternion, ...] | None
    """All images; None where they are infinitely many."""
    of_orbits: Callable[[], tuple[Quaternion, ...]] = field(compare=False)
    """Returns one of each orbit."""
    prime: object = None
    """A prime at which there is no embedding, or None."""
    of_orbits_claim: Callable[[], CertifiedClaim] | None = field(default=None, compare=False)
    """Returns the claim of :meth:`claim_of_orbits`; None in a definite algebra."""

    def __len__(self) -> int:
        return len(self.elements)

    @property
    def elements(self) -> tuple[Quaternion, ...]:
        """All images, in a definite algebra. Raises :class:`IndefiniteError`."""
        if self.listed is None:
            raise IndefiniteError(
                f"the embeddings in an order of {shorten(self.order.algebra)}, which is indefinite, are "
                "infinitely many: representatives has one of each orbit"
            )
        return self.listed

    @cached_property
    def representatives(self) -> tuple[Quaternion, ...]:
        """One image for each orbit under conjugation by units (in indefinite algebras, by units of norm 1).

        Raises :class:`TooLargeError` for a very large d.
        """
        return self.of_orbits() if self else ()

    @property
    def orbits(self) -> int:
        """The number of orbits. Raises as :attr:`representatives` does."""
        return len(self.representatives)

    def image(self, x: object) -> Quaternion:
        """Return the image of an element of the quadratic field F(√d) under the embedding of :attr:`element`.

        ``x`` is a pair (u, v) of numbers of F, for u + v·(t + √d)/2; or a number of F; or over ℚ an element
        of a quadratic number field of hfield. In the last case √d is the positive multiple of the difference
        of the generator and its conjugate. Raises :class:`LatticeError` for other x and if there is no
        embedding, and :class:`CoercionError` or :class:`NotationError` if u or v is not a number of F.

        >>> from hfield import QuaternionAlgebra, ring
        >>> E = QuaternionAlgebra(6).maximal_order().embeddings(-24)
        >>> E.image(ring("QQ(sqrt(-6))").gen) ** 2 == -6, E.image((12, 1)) == 12 + E.element
        (True, True)
        """
        if self.element is None:
            raise LatticeError(f"there is no embedding: {self.reason}")
        algebra = self.order.algebra
        u: object = x
        v: object = 0
        if isinstance(x, FieldElement) and x.field != algebra.ring:
            u, v = self._coordinates(x, Fraction(str(self.element.trace())))
        elif isinstance(x, tuple):
            if len(x) != 2:
                raise LatticeError(
                    f"{shorten(x)} is not a pair (u, v): expected one, for u + v·(t + √d)/2"
                )
            u, v = x
        F = algebra.ring
        found: Quaternion = algebra(F(u)) + algebra(F(v)) * self.element
        return found

    def _coordinates(self, x: FieldElement, t: Fraction) -> tuple[Fraction, Fraction]:
        """Return u and v with x = u + v·(t + √d)/2, for an element of a quadratic number field."""
        field, d = x.field, self.discriminant
        ratio = None
        if field.degree == 2 and self.order.value.ambient.base.is_rational:
            trace, norm = Fraction(str(field.gen.trace())), Fraction(str(field.gen.norm()))
            ratio = square_root(Fraction(str(d)) / (trace * trace - 4 * norm))
        if ratio is None:
            raise LatticeError(
                f"{shorten(x)} lies in {shorten(field.name)}, and not in the field of √({shorten(d)})"
            )
        # the generator is (trace + √d/ratio)/2
        u, v = (Fraction(str(c)) for c in field.coordinates(x))
        return u + v * (trace - t / ratio) / 2, v / ratio

    def ideal(
        self, a: NumberFieldIdeal | PrimeIdeal | Iterable[object], side: str = "left"
    ) -> Ideal:
        """Return the left ideal ``O·φ(a)`` for an ideal a of the quadratic order, where φ is the embedding.

        ``a`` is an ideal or a prime ideal of a quadratic number field, or a list of generators in the
        notation of :meth:`image`. With ``side="right"`` the result is ``φ(a)·O``. If a is invertible, so is
        the result; its norm is that of a, and ``O·φ(a)·φ(b)`` is ``O·φ(ab)``. Raises :class:`LatticeError`,
        and as :meth:`image` does.

        >>> from hfield import QuaternionAlgebra, ring
        >>> E = QuaternionAlgebra(6).maximal_order().embeddings(-24)
        >>> P = ring("QQ(sqrt(-6))").primes_above(5)[0]
        >>> E.ideal(P).norm(), E.ideal([5, (1, 1)]).norm()
        (5, 1)
        """
        elements: Iterable[object]
        if isinstance(a, NumberFieldIdeal):
            elements = a.basis
        elif isinstance(a, PrimeIdeal):
            elements = a.generators
        else:
            elements = listed(a)
        images = [self.image(x) for x in elements]
        if checked_side(side) == "left":
            return self.order.left_ideal(images)
        return self.order.right_ideal(images)

    @cached_property
    def claim(self) -> CertifiedClaim:
        """The claim that there is an embedding, or none, with its evidence.

        Raises :class:`LatticeError` over ℤ_K, and in an indefinite algebra if there is no embedding but no
        prime with a local obstruction is known.
        """
        return certificates.of_embedding(
            self.order.value, self.discriminant, self.element, self.prime
        )

    def claim_of_orbits(self) -> CertifiedClaim:
        """Return the claim of the number of orbits, with all orbits as evidence.

        It has a ``certificate`` for Eichler orders over ℤ and d < 0; if there are no embeddings it equals
        :attr:`claim`. Raises :class:`LatticeError` in a definite algebra and over ℤ_K.

        >>> from hfield import QuaternionAlgebra, check
        >>> E = QuaternionAlgebra(6).eichler_order(5).embeddings(-24)
        >>> E.orbits, check(E.claim_of_orbits().certificate).verdict
        (8, 'proved')
        """
        if not self:
            return self.claim
        if self.of_orbits_claim is None:
            raise LatticeError("the orbits of embeddings are certified in indefinite algebras only")
        return self.of_orbits_claim()


def embeddings(
    order: LatticeValue, d: object
) -> tuple[tuple[Quaternion, ...], tuple[Quaternion, ...]]:
    """Return all elements and all representatives of :class:`Embeddings`, in a definite algebra.

    Raises :class:`LatticeError` unless d is a totally negative discriminant, and :class:`IndefiniteError`.
    """
    ambient, base = order.ambient, order.ambient.base
    expect_definite(ambient, "embeddings()")
    x = base.inside(d)
    t = base.root_modulo_4(x)
    if t is None or not base.is_totally_positive(-x):
        raise LatticeError(
            f"{shorten(d)} is not a discriminant of a totally imaginary quadratic order over the integers of "
            f"{shorten(base.ring.name)}: expected a totally negative integer, a square modulo 4"
        )
    vectors = list(_of_trace_zero(order, -x))
    if not vectors:
        return (), ()
    both = sorted((*vectors, *(-s for s in vectors)), key=fmpq_mat.entries, reverse=True)
    shift = ambient.one * ambient.scalar(t)

    def images(some: list[fmpq_mat]) -> tuple[Quaternion, ...]:
        return tuple(ambient.quaternion(((shift + s) * fmpq(1, 2)).entries()) for s in some)

    return images(both), images(_orbits(order, both))


def _of_trace_zero(order: LatticeValue, norm: BaseNumber) -> Iterator[fmpq_mat]:
    """Yield one of ±s for each primitive s of trace 0 in R + 2O with a given totally positive norm."""
    ambient, n = order.ambient, order.ambient.degree
    rational = ambient.base.as_rational(norm)
    if rational is not None:  # Tr(N(s)/ν) is a multiple of Tr(N(s))
        den, rows, gram = order.reduced_ternary
        length = 2 * n * rational
    else:
        gram, basis, scale = reduced(ambient, ternary_rows(order), 1 / norm)
        den, rows = hermite.rational(basis)
        length = fmpq(2 * n * scale)
    if length.q != 1:
        return
    tables = multiplications(ambient, rows)
    for v in enumeration.vectors_of_length(gram, int(length.p), "elements of norm at most"):
        vector = fmpz_mat([list(v)])
        row = vector * rows
        if ambient.kernels.has_norm(ambient, den, row, norm) and is_primitive(vector, tables):
            yield row * fmpq(1, den)


def is_primitive(vector: fmpz_mat, multiplications: list[fmpz_mat]) -> bool:
    """Return whether c·v lies in the lattice only for integers c of the base; v is a vector of the
    lattice.
    """
    multiples = hermite.stacked(vector, *(vector * m for m in multiplications))
    return bool(hermite.volume(multiples.transpose().hnf()) == 1)


def multiplications(ambient: AlgebraBasis, rows: fmpz_mat) -> list[fmpz_mat]:
    """Return the matrices of multiplication by the integral basis, except 1, on rows of trace 0."""
    n = ambient.degree
    if n == 1:
        return []
    pure = fmpz_mat([row[n:] for row in rows.tolist()])
    blocks = (fmpz_mat([row[n:] for row in m.tolist()[n:]]) for m in ambient.scalars[1:])
    inverse = pure.inv()
    return [(fmpq_mat(pure * block) * inverse).numer_denom()[0] for block in blocks]


def _orbits(order: LatticeValue, elements: list[fmpq_mat]) -> list[fmpq_mat]:
    """Return one element from each orbit under conjugation by the units of an order."""
    if not elements:
        return []
    times = order.ambient.times
    maps = [times(u, "left") * times(u).inv() for u in units_modulo_scalars(order)]
    left, found = {tuple(s.entries()): s for s in elements}, list[fmpq_mat]()
    while left:
        s = next(iter(left.values()))
        for m in maps:
            left.pop(tuple((s * m).entries()), None)
        found.append(s)
    return found


# --- norm equations --------------------------------------------------------------------------------


def represent_integer(order: LatticeValue, n: object, seed: int | None = None) -> Quaternion | None:
    """Return an element of an order with norm n, or None if there is none.

    Small n are decided by enumeration. For other n, an obstruction at a prime is searched for first, and then
    an element: over ℤ in the frame of a quadratic order, over other bases in random ideals. Raises
    :class:`IndefiniteError`, and :class:`UndecidedError`.
    """
    ambient, base = order.ambient, order.ambient.base
    expect_definite(ambient, "represent_integer()")
    norm = base.inside(n)
    if not norm:
        return ambient.quaternion([ambient.domain.fraction(0)] * ambient.size)
    integral = base.coordinate_rows([norm]).numer_denom()[1] == 1
    form = form_of_norm(order, norm) if integral and base.is_totally_positive(norm) else None
    if form is None:
        return None
    gram, _, length = form
    if ambient.domain.vectors.volume(gram, length, len(gram) - 1) < MAX_ENUMERATED:
        return _first_of_norm(order, norm)
    if not is_eichler(order) and any(
        is_obstructed(order, P, norm) for P, e in base.factorisation(discriminant(order)) if e > 1
    ):
        return None
    rng = Random(0 if seed is None else seed)
    return ambient.kernels.choose(in_random_ideals, rank4=in_quadratic_orders)(order, norm, rng)


def in_random_ideals(order: LatticeValue, norm: BaseNumber, rng: Random) -> Quaternion | None:
    """Return an element of a given norm as generator of a random ideal, or None. Raises
    :class:`UndecidedError`.

    If it returns None, it is proved that no ideal has this norm.
    """
    base = order.ambient.base
    ideals = _random_ideals(order, norm, rng)
    if ideals is None:
        return None
    for ideal in ideals:
        x = _first_of_norm(ideal, norm)
        if x is not None:
            return x
    raise UndecidedError(
        f"whether the norm of an element is {shorten(base.outside(norm))} was not decided: no prime rules "
        f"it out, and of {TRIALS} random ideals of this norm none has such a generator"
    )


def in_quadratic_orders(order: LatticeValue, norm: BaseNumber, rng: Random) -> Quaternion | None:
    """Return an element of a given norm in an order over ℤ, or None if none was found; for a small
    discriminant all methods are tried.
    """
    n = int(order.ambient.base.trace(norm).p)
    found = element_of_large_norm(order, n, rng)
    if found is not None:
        return found
    if volume(order) < SMALL_VOLUME:
        lattice, factor, rest = order, 1, n
        total = fraction(discriminant(order)).numerator
        for P in order.ambient.ramified:
            p = int(fraction(P))
            if total % p**2 == 0:
                continue
            # the elements whose norm p divides are those of the two-sided prime ideal
            e, rest = remove(rest, p)
            factor *= p ** (e // 2)
            if e % 2:
                lattice = product_of_lattices(two_sided_prime(order, P), lattice)
        x, decided = of_norm(lattice, rest, rng)
        if decided:
            return None if x is None else factor * x
    d = frame(order).discriminant
    raise UndecidedError(
        f"no element of norm {shorten(n)} was found in {TRIALS_IN_FRAME} trials; the order contains "
        f"quadratic orders of discriminant {shorten(d)} and beyond only"
    )


def _first_of_norm(lattice: LatticeValue, norm: BaseNumber) -> Quaternion | None:
    row = next(rows_of_norm(lattice, norm), None)
    return None if row is None else lattice.ambient.quaternion(row.entries())


def _random_ideals(
    order: LatticeValue, norm: BaseNumber, rng: Random
) -> Iterator[LatticeValue] | None:
    """Return several random right ideals of an order with norm generated by a given number; None if none
    exist.
    """
    base, whole = order.ambient.base, discriminant(order)
    known, all_at_prime, good = [], [], base.one
    for P, e in base.factorisation(base.principal(norm)):
        bad = base.valuation(whole, P)
        if not bad:
            good *= base.prime_ideal(P) ** e
            continue
        number = number_maximal(base.absolute_norm(base.prime_ideal(P)), e)
        if not is_maximal_or_eichler(order, P, bad) and number < MAX_LOCAL_IDEALS:
            # not all ideals of norm Pᵉ are products of ideals of norm P
            with suppress(TooLargeError):
                all_at_prime.append(of_prime_power_norm(order, P, e))
                continue
        some = of_prime_norm(order, P)
        if not some.generators:
            raise UndecidedError(
                f"whether the norm of an element is {shorten(base.outside(norm))} was not decided: no ideal "
                f"has the norm {P}, and those of the norm {P}^{e} are too many to list them"
            )
        known += [some] * e
    if not all(all_at_prime):
        return None

    def one() -> LatticeValue:
        ideal = conjugate(random_ideal(order, good, rng))
        for ideals in known:
            ideal = ideals.random_inside(ideal, rng)
        for ideals_at_prime in all_at_prime:
            ideal = meet(ideal, rng.choice(ideals_at_prime))
        return ideal

    return (one() for _ in range(TRIALS))


def is_obstructed(order: LatticeValue, prime: Prime, norm: BaseNumber) -> bool:
    """Return True if it is proved that the completion of the order at P has no element of this norm n.

    False is also returned if the search would be too large. By Hensel's lemma an x outside P·O can be changed
    to an element of norm n if v(N(x) − n) > 2·v(tr(x·conj(y))) for some y in O. If x in P·O has norm n, then
    x/π has norm n/π².
    """
    at = OrderAtPrime(order, prime)
    if at.norm**4 > MAX_CLASSES:
        return False
    place, number, domain = at.place, at.base.element_of, at.domain
    classes = list(_classes(at))
    uniformiser = at.coordinates(order.rows * at.ambient.scalar(place.uniformiser))

    def solvable(target: BaseNumber) -> bool:
        power = at.ambient.identity
        level = classes[1:]  # but 0
        for k in count(1):
            rest = []
            for x in level:
                value = number([domain.fraction(c) for c in at.norm_of(x.entries())])
                if value != target and place.valuation(value - target) < k:
                    continue
                images = [form * x.transpose() for form in at.traces]
                slopes = (
                    number([domain.fraction(image[m, 0]) for image in images])
                    for m in range(at.ambient.size)
                )
                slope = min((place.valuation(s) for s in slopes if s), default=math.inf)
                if value == target or place.valuation(value - target) > 2 * slope:
                    return True
                rest.append(x)
            if len(rest) * len(classes) > MAX_CLASSES:
                return True  # not known
            power = power * uniformiser
            shifts = [c * power for c in classes]
            level = [x + v for x in rest for v in shifts]
            if not level:
                break
        lower = target / (place.uniformiser * place.uniformiser)
        return place.valuation(lower) >= 0 and solvable(lower)

    return not solvable(norm)


def _classes(at: OrderAtPrime) -> Iterator[fmpz_mat]:
    """Yield coordinates of representatives of an order modulo P times it, 0 first."""
    scalars = [at.ambient.scalar(c) for c in at.representatives]
    multiples = [[at.coordinates(b * c) for c in scalars] for b in at.basis_modulo_prime]
    for chosen in product(*multiples):
        total = chosen[0]
        for x in chosen[1:]:
            total = total + x
        yield total
