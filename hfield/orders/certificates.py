"""Certificates ``hfield-cert/2`` of orders, ideals and results about them.

``_Rational``, ``_OverField`` and ``_OverPolynomials`` define how statements and evidence are written over ℤ,
the integers of a number field and 𝔽_q[t]. docs/reference/certificates.md lists them.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from fractions import Fraction
from itertools import combinations
from typing import TYPE_CHECKING, ClassVar, Protocol, cast

import flint

from hfield.checker.glossary import (
    BY_AREA,
    BY_CLASS_NUMBER,
    BY_EIGENVECTORS,
    BY_MASS,
    BY_PRIME,
    DISCRIMINANT,
    ELEMENT,
    EMBEDDING_NUMBERS,
    ENUMERATION,
    IDEAL,
    MASS,
    MASS_OVER_FIELDS,
    MASS_OVER_POLYNOMIALS,
    NEW_FUNCTIONS,
    NEW_FUNCTIONS_OF_WEIGHT,
    NORM,
    ORDER,
    SHIMIZU,
    SIEGEL,
    SIGNS,
)
from hfield.core.factorisation import factorise
from hfield.core.primality import is_prime
from hfield.errors import LatticeError
from hfield.evidence import CertifiedClaim
from hfield.fields.number_fields.classes import evidence
from hfield.fields.number_fields.classes.s_units import s_units
from hfield.fields.rationals.whole_numbers import fraction, square_root
from hfield.orders import enumeration
from hfield.orders.base import number_field_integers
from hfield.orders.base_values import BaseIdeal, BaseNumber, Prime, ShownIdeal
from hfield.orders.conjugators import two_generators
from hfield.orders.invariants import level
from hfield.orders.lattice_values import LatticeValue, colon, conjugate, discriminant, index
from hfield.orders.positive_generators import totally_positive_generator
from hfield.orders.short_elements import reduced
from hfield.orders.validation import expect_rational

if TYPE_CHECKING:
    from hfield.algebra.quaternion import Quaternion
    from hfield.fields.number_fields.ideals import FractionalIdeal
    from hfield.fields.number_fields.ring import NumberField
    from hfield.orders.basis import AlgebraBasis
    from hfield.orders.classes import Classes
    from hfield.verdicts import Verdict

REFUSAL = "the checker does not know that strong approximation decides"
EQUIVALENT, ISOMORPHIC = "equivalent", "isomorphic"
DOUBLINGS = 6
MAX_COUNTED = 10**5
"""So many elements, about, are counted to tell two orders apart."""

Refutation = tuple[str, dict[str, object]]
"""A method, and evidence without its kind."""


# --- statements ------------------------------------------------------------------------------------


def of_order(order: LatticeValue) -> CertifiedClaim:
    """Return a certified claim of the discriminant of an order, and of its maximality if possible."""
    words = _words(order.ambient)
    about = f"{text(order)}; {words.size(discriminant(order))}"
    if words.states_maximality and level(order) == 1:
        claim = words.claim(ORDER, f"{about}; maximal", ORDER)
        if claim.certificate is not None:
            return claim
    return words.claim(ORDER, about, ORDER)


def of_ideal(ideal: LatticeValue, side: str, order: LatticeValue) -> CertifiedClaim:
    """Return the claim that an ideal of an order is locally principal and has this norm."""
    words = _words(ideal.ambient)
    about = f"{text(ideal)}; {_side(side)}; {text(order)}; {words.size(ideal.norm)}"
    return words.claim(IDEAL, about, IDEAL)


def of_equivalence(
    side: str,
    first: LatticeValue,
    second: LatticeValue,
    between: LatticeValue | None,
    result: Verdict[Quaternion],
) -> CertifiedClaim:
    """Return the certified claim that an element maps one ideal onto another, or that none does.

    ``between`` is the lattice of all c with first·c in second, or c·first in second for right ideals; it is
    computed if it is not given.
    """
    about = f"{_side(side)}; {text(first)}; {text(second)}"
    words = _words(first.ambient)
    if result:
        return _proved(words, EQUIVALENT, about, result)
    if between is None:
        between = colon(second, first, "left" if side == "right" else "right")
    found = words.no_equivalence(_side(side), first, second, between)
    return _refuted(words, EQUIVALENT, about, found)


def of_isomorphism(
    first: LatticeValue, second: LatticeValue, result: Verdict[Quaternion]
) -> CertifiedClaim:
    """Return the claim that an element conjugates one order into another, or that they are not isomorphic."""
    about = f"{text(first)}; {text(second)}"
    words = _words(first.ambient)
    if result:
        return _proved(words, ISOMORPHIC, about, result)
    found: Refutation | None = DISCRIMINANT, {}
    if words.size(discriminant(first)) == words.size(discriminant(second)):
        found = words.no_isomorphism(first, second) if first.ambient.definite else None
    return _refuted(words, ISOMORPHIC, about, found)


def _proved(words: _Words, word: str, about: str, result: Verdict[Quaternion]) -> CertifiedClaim:
    """Return a proved verdict that an element exists; None if the element is not known."""
    if result.element is None:
        return words.claim(word, about, "strong approximation", refusal=REFUSAL)
    return words.claim(word, about, ELEMENT, element=words.element(result.element))


def _refuted(words: _Words, word: str, about: str, found: Refutation | None) -> CertifiedClaim:
    """Return a refuted verdict that an element exists; None without evidence."""
    if found is None:
        reason = "nothing that the checker follows was found to tell them apart"
        return words.claim(word, about, ENUMERATION, "refuted", refusal=reason)
    method, shown = found
    return words.claim(word, about, method, "refuted", None, **shown)


def of_unit_index(order: LatticeValue, number: int) -> CertifiedClaim:
    """Return the claim of the number of units modulo those of the field, for an order over ℤ_K or 𝔽_q[t]."""
    words = _words(order.ambient)
    shown = words.of_unit_index(order)
    return words.claim(
        "unit-index", f"{text(order)}; {number}", ENUMERATION, "proved", None, **shown
    )


def of_units(
    order: LatticeValue, word: str, parts: list[str], shown: dict[str, object], *cited: str
) -> CertifiedClaim:
    """Return a statement about the units of norm 1 of an order that splits at one real place."""
    words = _words(order.ambient)
    kind = words.names.get(word, word)
    data = {"kind": kind, **words.of_mass(order), **shown}
    statement = f"{kind}{{{'; '.join([text(order), *parts])}}}"
    return CertifiedClaim(
        order.algebra, statement, data, BY_AREA, assumes=(*words.area_theorems, *cited)
    )


def of_class_set(classes: Classes) -> CertifiedClaim:
    """Return the claim of the number of right ideal classes of an order, with one ideal of each."""
    return _words(classes.ambient).class_set(classes)


def of_embedding(
    order: LatticeValue, d: object, element: Quaternion | None, prime: object = None
) -> CertifiedClaim:
    """Return the claim that a quadratic order is, or is not, optimally embedded in an order over ℤ.

    The evidence for nonexistence is a prime without a local embedding, or in a definite algebra a complete
    list. Raises :class:`LatticeError` over another base, and in an indefinite algebra if no prime is given.
    """
    _expect_rational_base(order)
    words = _words(order.ambient)
    statement = f"embedding{{{text(order)}; {d}}}"
    shown: dict[str, object] = {"kind": "embedding"}
    if element is not None:
        shown["element"] = words.element(element)
        return CertifiedClaim(order.algebra, statement, shown, ELEMENT)
    if prime is not None:
        shown["prime"] = prime
        return CertifiedClaim(order.algebra, statement, shown, BY_PRIME, "refuted")
    if not order.ambient.definite:
        raise LatticeError(
            "that no embedding exists has a certificate where a prime rules it out, and here none is known to"
        )
    shown["basis"] = _basis(order, order.ambient.base.field.one)
    return CertifiedClaim(order.algebra, statement, shown, ENUMERATION, "refuted")


def of_embedding_orbits(
    order: LatticeValue,
    d: object,
    elements: Sequence[Quaternion],
    center: Quaternion,
    units: Sequence[Quaternion],
) -> CertifiedClaim:
    """Return the claim of the number of orbits of embeddings under units of norm 1, conjugates included.

    For d < 0 the fixed points lie in the domain around a centre that the units bound. For d > 0 the elements
    are one of each orbit, and there is no certificate. Raises :class:`LatticeError` over bases other than ℤ.
    """
    _expect_rational_base(order)
    written = _words(order.ambient).element
    shown = {
        "kind": "embedding-orbits",
        "center": written(center),
        "units": list(map(written, units)),
        "elements": list(map(written, elements)),
    }
    negative = order.ambient.base.is_totally_positive(-order.ambient.base.inside(d))
    number = (2 if negative else 1) * len(elements)
    statement = f"embedding-orbits{{{text(order)}; {d}; {number}}}"
    return CertifiedClaim(
        order.algebra,
        statement,
        shown,
        BY_CLASS_NUMBER,
        assumes=(SHIMIZU, EMBEDDING_NUMBERS),
        refusal=None if negative else "the checker counts orbits of negative discriminants only",
    )


def _expect_rational_base(order: LatticeValue) -> None:
    error = LatticeError("embeddings are certified over ℤ only, where statements about them exist")
    expect_rational(order.ambient.base, error)


def of_newforms(
    classes: Classes,
    primes: tuple[Sequence[Prime], Sequence[Prime]],
    parts: tuple[str, str, str],
    shown: dict[str, object],
    refusal: str | None,
) -> CertifiedClaim:
    """Return the certified claim of newforms, with eigenvalues and signs at primes.

    ``parts`` are the weight, the orbits with eigenvalues and their signs.
    """
    words = _words(classes.ambient)
    of_classes = words.class_set(classes)
    name = words.names.get("newforms", "newforms")
    of_eigenvalues, of_signs = primes
    data = {**words.with_primes(of_classes.evidence, of_eigenvalues), "kind": name, **shown}
    weight, orbits, signs = parts
    about = [text(classes.order), weight, words.primes_text(of_eigenvalues), orbits]
    cited = [*of_classes.assumes, NEW_FUNCTIONS if weight == "2" else NEW_FUNCTIONS_OF_WEIGHT]
    if of_signs:
        about += [words.primes_text(of_signs), signs]
        cited.append(SIGNS)
    return CertifiedClaim(
        classes.order.algebra,
        f"{name}{{{'; '.join(about)}}}",
        data,
        BY_EIGENVECTORS,
        assumes=tuple(cited),
        refusal=refusal,
    )


# --- how values are written ------------------------------------------------------------------------


def text(lattice: LatticeValue) -> str:
    """Write a ℤ-basis of a lattice in the notation of statements."""
    write = lattice.algebra.ring.text
    return " | ".join(",".join(map(write, q.coordinates)) for q in lattice.basis)


def element_json(ambient: AlgebraBasis, q: Quaternion) -> object:
    """Return an element in the notation of evidence."""
    return _words(ambient).element(q)


def class_group_primes(ambient: AlgebraBasis) -> list[Prime]:
    """Return the prime ideals of the evidence that generate the class group, none if all are principal."""
    if not ambient.base.class_generators:
        return []
    s = s_units(ambient.base.ring)
    return [s.base[k] for k in s.primes]


def _side(side: str) -> str:
    """Return the side that a statement names; a two-sided ideal counts as a left ideal."""
    return "right" if side == "right" else "left"


def lattice_json(lattice: LatticeValue) -> dict[str, object]:
    """Return a reduced basis of a lattice in the notation of evidence."""
    return _basis(lattice, lattice.ambient.base.field.one)


def _basis(lattice: LatticeValue, norm: BaseNumber) -> dict[str, object]:
    """Return a basis of a lattice reduced for Tr(N(x)/ν), so that enumeration is fast."""
    if lattice.ambient.base.as_rational(norm) is not None:  # the form is a multiple of Tr(N(x))
        rows = lattice.reduced[0] * flint.fmpq(1, lattice.den)
    else:
        rows = reduced(lattice.ambient, lattice.rows, 1 / norm)[1]
    den, table = _coordinates(lattice.ambient, rows)
    return {"den": den, "rows": table}


def _coordinates(ambient: AlgebraBasis, rows: flint.fmpq_mat) -> tuple[int, list[list[int]]]:
    """Return elements w + x·i + y·j + z·k as rows over a denominator, with parts in the integral basis."""
    base = ambient.base
    numbers = [base.inside(x) for row in rows.tolist() for x in ambient.quaternion(row).coordinates]
    entries = base.coordinate_rows(numbers).entries()
    whole, den = flint.fmpq_mat(rows.nrows(), ambient.size, entries).numer_denom()
    return int(den), [list(map(int, row)) for row in whole.tolist()]


# --- the three vocabularies --------------------------------------------------------------------------


class _Words(Protocol):
    """The notation of statements and evidence over a base."""

    names: ClassVar[dict[str, str]]
    """The words that are not the plain ones."""
    states_maximality: ClassVar[bool]
    area_theorems: ClassVar[tuple[str, ...]]

    def size(self, ideal: BaseIdeal) -> ShownIdeal | str:
        """Return the number by which statements name an ideal of the base."""

    def element(self, q: Quaternion) -> object:
        """Return an element of the algebra."""

    def of_mass(self, order: LatticeValue) -> dict[str, object]:
        """Return the data, besides the order, that a formula for a mass or an area needs."""

    def claim(
        self,
        word: str,
        about: str,
        method: str,
        verdict: str = "proved",
        refusal: str | None = None,
        **shown: object,
    ) -> CertifiedClaim:
        """Return a statement with its evidence."""

    def of_unit_index(self, order: LatticeValue) -> dict[str, object]:
        """Return the evidence for the number of units modulo those of the base."""

    def class_set(self, classes: Classes) -> CertifiedClaim:
        """Return the claim of the number of right ideal classes of an order, with one ideal of each."""

    def primes_text(self, primes: Sequence[Prime]) -> str:
        """Write primes in the notation of statements."""

    def with_primes(self, shown: dict[str, object], primes: Sequence[Prime]) -> dict[str, object]:
        """Return the evidence, extended by the data of some primes."""

    def no_equivalence(
        self, side: str, first: LatticeValue, second: LatticeValue, between: LatticeValue
    ) -> Refutation | None:
        """Return the evidence that no element maps one ideal onto another, if there is any."""

    def no_isomorphism(self, first: LatticeValue, second: LatticeValue) -> Refutation | None:
        """Return a proof that definite orders of one discriminant are not isomorphic, or None."""


def _words(ambient: AlgebraBasis) -> _Words:
    return VOCABULARIES[ambient.base.vocabulary](ambient)


class _Rational:
    """The notation over ℤ."""

    names: ClassVar = {ISOMORPHIC: "isomorphic-orders"}
    states_maximality: ClassVar = True
    area_theorems: ClassVar[tuple[str, ...]] = (SHIMIZU,)

    def __init__(self, ambient: AlgebraBasis) -> None:
        self.ambient = ambient

    def size(self, ideal: BaseIdeal) -> ShownIdeal:
        return self.ambient.base.shown_index(ideal)

    def element(self, q: Quaternion) -> list[str]:
        return [q.ring.text(x) for x in q.coordinates]

    def of_mass(self, order: LatticeValue) -> dict[str, object]:
        return {}

    def of_unit_index(self, order: LatticeValue) -> dict[str, object]:
        raise LatticeError(
            "there is no statement about the index of units over ℤ, where all units of an order are listed"
        )

    def claim(
        self,
        word: str,
        about: str,
        method: str,
        verdict: str = "proved",
        refusal: str | None = None,
        **shown: object,
    ) -> CertifiedClaim:
        name, algebra = self.names.get(word, word), self.ambient.algebra
        data = {"kind": name, **shown}
        return CertifiedClaim(algebra, f"{name}{{{about}}}", data, method, verdict, refusal=refusal)

    def class_set(self, classes: Classes) -> CertifiedClaim:
        order, base = classes.order, self.ambient.base
        lattices = map(classes.lattice, range(len(classes)))
        shown: dict[str, object] = {
            "kind": "class-set",
            "classes": [_basis(I, base.inside(I.norm)) for I in lattices],
        }
        statement = f"class-set{{{text(order)}; {len(classes)}}}"
        return CertifiedClaim(order.algebra, statement, shown, BY_MASS, assumes=(MASS,))

    def primes_text(self, primes: Sequence[Prime]) -> str:
        return ",".join(map(str, primes))

    def with_primes(self, shown: dict[str, object], primes: Sequence[Prime]) -> dict[str, object]:
        return shown

    def no_equivalence(
        self, side: str, first: LatticeValue, second: LatticeValue, between: LatticeValue
    ) -> Refutation:
        size = square_root(fraction(index(first, second)))
        if size is None or (size / fraction(between.norm)).denominator != 1:
            return NORM, {}
        return ENUMERATION, {"between": _basis(between, self.ambient.base.inside(size))}

    def no_isomorphism(self, first: LatticeValue, second: LatticeValue) -> Refutation | None:
        """Return a trace and norm for which one order has more elements than the other.

        Sufficiently many terms of ternary theta series distinguish all orders (Schiemann, *Math. Ann.* 308,
        1997).
        """
        orders = [first, second]
        grams = [order.reduced_ternary[2] for order in orders]
        reach = min(gram[n][n] for gram in grams for n in range(3)) // 2
        for _ in range(DOUBLINGS):
            if max(enumeration.volume(gram, 2 * reach, 3) for gram in grams) > MAX_COUNTED:
                return None
            both = zip(*(enumeration.theta_series(gram, reach) for gram in grams), strict=True)
            for m, (one, other) in enumerate(both):
                if one != other:  # x of trace 0 or 1 and discriminant −m
                    one_of_field = self.ambient.base.field.one
                    bases = [_basis(order, one_of_field) for order in orders]
                    return ENUMERATION, {
                        "trace": m % 2,
                        "norm": (m + m % 2) // 4,
                        "bases": bases,
                    }
            reach *= 2
        return None


class _OverField:
    """The notation over the integers of a number field."""

    names: ClassVar = {
        word: f"{word}-over-integers"
        for word in (
            ORDER,
            IDEAL,
            EQUIVALENT,
            ISOMORPHIC,
            "dirichlet-domain",
            "norm-one-group",
            "newforms",
        )
    }
    states_maximality: ClassVar = False
    area_theorems: ClassVar[tuple[str, ...]] = (SIEGEL, SHIMIZU)

    def __init__(self, ambient: AlgebraBasis) -> None:
        self.ambient, self.integers = ambient, number_field_integers(ambient.base)

    def size(self, ideal: BaseIdeal) -> Fraction | int:
        return self.integers.ideal(ideal).norm()

    def element(self, q: Quaternion) -> dict[str, object]:
        return self._row(self.ambient.row(q))

    def _row(self, row: flint.fmpq_mat) -> dict[str, object]:
        den, table = _coordinates(self.ambient, row)
        return {"den": den, "row": table[0]}

    @property
    def _integral_basis(self) -> list[object]:
        return [x.field.coordinates(x) for x in self.integers.integral_basis]

    def of_mass(self, order: LatticeValue) -> dict[str, object]:
        return {"basis": self._integral_basis, "primes": _primes(order)}

    def of_unit_index(self, order: LatticeValue) -> dict[str, object]:
        return {**self._units(), "order": _basis(order, self.ambient.base.field.one)}

    def claim(
        self,
        word: str,
        about: str,
        method: str,
        verdict: str = "proved",
        refusal: str | None = None,
        **shown: object,
    ) -> CertifiedClaim:
        name, algebra = self.names.get(word, word), self.ambient.algebra
        cited: tuple[str, ...] = ()
        if "units" in shown:
            cited = evidence.cited(s_units(self.ambient.base.ring))
        else:
            shown["basis"] = self._integral_basis
        data = {"kind": name, **shown}
        return CertifiedClaim(
            algebra, f"{name}{{{about}}}", data, method, verdict, cited, refusal=refusal
        )

    def class_set(self, classes: Classes) -> CertifiedClaim:
        order, ring, read = classes.order, self.integers.ring, self.integers.ideal
        shown = {
            "kind": "ideal-classes",
            **self._units(),
            "narrow": [_product(ring, read(a)) for a in classes.keys.narrow.ideals],
            "primes": _primes(order),
            "classes": [self._class(classes, n) for n in range(len(classes))],
        }
        cited = (*evidence.cited(s_units(ring)), SIEGEL, MASS_OVER_FIELDS)
        statement = f"ideal-classes{{{text(order)}; {len(classes)}}}"
        return CertifiedClaim(order.algebra, statement, shown, BY_MASS, assumes=cited)

    def primes_text(self, primes: Sequence[Prime]) -> str:
        return " | ".join(map(str, primes))

    def with_primes(self, shown: dict[str, object], primes: Sequence[Prime]) -> dict[str, object]:
        base = self.ambient.base
        s = s_units(base.ring)
        given = cast("list[tuple[int, object]]", shown["primes"])
        more = sorted({base.place(P).below for P in primes} - {p for p, _ in given})
        return {**shown, "primes": [*given, *([p, evidence.seconds_above(s, p)] for p in more)]}

    def no_equivalence(
        self, side: str, first: LatticeValue, second: LatticeValue, between: LatticeValue
    ) -> Refutation | None:
        ambient = self.ambient
        quotient = self.integers.ideal(second.norm / first.norm)
        nu, shown = totally_positive_generator(quotient), self._units()
        if nu is None:
            return NORM, {**shown, "quotient": _product(self.integers.ring, quotient)}
        if not ambient.definite:
            return None
        if side == "right":
            between = conjugate(between)
        norm = nu.field.coordinates(nu)
        return ENUMERATION, {**shown, "norm": norm, "between": _basis(between, nu)}

    def no_isomorphism(self, first: LatticeValue, second: LatticeValue) -> Refutation:
        pair = [self._row(x) for x in two_generators(first)]
        return ENUMERATION, {"pair": pair, "order": _basis(second, self.ambient.base.field.one)}

    def _units(self) -> dict[str, object]:
        """Return the evidence for the units of the field."""
        ring = self.integers.ring
        units = ring.unit_group().generators
        shown = evidence.evidence(s_units(ring))
        return {"units": shown, "fundamental": list(map(ring.coordinates, units))}

    def _class(self, classes: Classes, n: int) -> dict[str, object]:
        """Return a reduced basis and a generator of the norm for class n."""
        norm, integers = classes.norms[n], self.integers
        return {
            **_basis(classes.lattice(n), norm.element),
            "norm": integers.ring.coordinates(integers.inside(norm.element)),
            "narrow": norm.number,
        }


class _OverPolynomials:
    """The notation over polynomials over a finite field; evidence is written like statements."""

    names: ClassVar = {
        word: f"{word}-over-polynomials"
        for word in (ORDER, IDEAL, EQUIVALENT, ISOMORPHIC, "unit-index", "class-set")
    }
    states_maximality: ClassVar = False
    area_theorems: ClassVar[tuple[str, ...]] = ()

    def __init__(self, ambient: AlgebraBasis) -> None:
        self.ambient = ambient

    def size(self, ideal: BaseIdeal) -> str:
        base = self.ambient.base
        generator, *_ = base.generators(ideal, ())  # the monic one
        return self.ambient.algebra.ring.text(base.outside(generator))

    def element(self, q: Quaternion) -> str:
        return ",".join(map(q.ring.text, q.coordinates))

    def of_mass(self, order: LatticeValue) -> dict[str, object]:
        base = self.ambient.base
        primes = base.factorisation(discriminant(order))
        return {"primes": [self.size(base.prime_ideal(P)) for P, _ in primes]}

    def of_unit_index(self, order: LatticeValue) -> dict[str, object]:
        return {"order": self.reduced_text(order)}

    def reduced_text(self, lattice: LatticeValue) -> str:
        """Return a reduced basis in the notation of statements."""
        return " | ".join(map(self.element, lattice.elements(lattice.reduced[0])))

    def claim(
        self,
        word: str,
        about: str,
        method: str,
        verdict: str = "proved",
        refusal: str | None = None,
        **shown: object,
    ) -> CertifiedClaim:
        name = self.names[word]
        data = {"kind": name, **shown}
        statement = f"{name}{{{about}}}"
        return CertifiedClaim(
            self.ambient.algebra, statement, data, method, verdict, refusal=refusal
        )

    def class_set(self, classes: Classes) -> CertifiedClaim:
        order, kind = classes.order, self.names["class-set"]
        lattices = map(classes.lattice, range(len(classes)))
        shown = {
            "kind": kind,
            **self.of_mass(order),
            "classes": list(map(self.reduced_text, lattices)),
        }
        statement = f"{kind}{{{text(order)}; {len(classes)}}}"
        cited = (MASS_OVER_POLYNOMIALS,)
        return CertifiedClaim(order.algebra, statement, shown, BY_MASS, assumes=cited)

    def primes_text(self, primes: Sequence[Prime]) -> str:
        return ",".join(map(str, primes))

    def with_primes(self, shown: dict[str, object], primes: Sequence[Prime]) -> dict[str, object]:
        return shown

    def no_equivalence(
        self, side: str, first: LatticeValue, second: LatticeValue, between: LatticeValue
    ) -> Refutation | None:
        if not self.ambient.definite:
            return None
        return ENUMERATION, {"between": self.reduced_text(between)}

    def no_isomorphism(self, first: LatticeValue, second: LatticeValue) -> Refutation:
        pair = list(map(self.element, _two_short_generators(first)))
        return ENUMERATION, {"pair": pair, "order": self.reduced_text(second)}


VOCABULARIES: dict[str, Callable[[AlgebraBasis], _Words]] = {
    "integers": _Rational,
    "field": _OverField,
    "polynomials": _OverPolynomials,
}
"""The vocabularies, by the names that bases have for them."""


def _two_short_generators(order: LatticeValue) -> tuple[Quaternion, Quaternion]:
    """Return two noncommuting elements of a reduced basis."""
    elements = order.elements(order.reduced[0])
    pairs = combinations(elements, 2)
    return next((x, y) for x, y in pairs if x * y != y * x)


def _primes(order: LatticeValue) -> list[object]:
    """Return the prime ideals that the mass formula and Siegel's formula need."""
    s = s_units(order.ambient.base.ring)
    # σ₁ is summed over ideals of norm at most the discriminant, whose square factors must be known
    wanted = {p for p in range(2, math.isqrt(s.field.discriminant()) + 1) if is_prime(p)}
    wanted |= set(factorise(order.ambient.base.absolute_norm(discriminant(order))))
    return [[p, evidence.seconds_above(s, p)] for p in sorted(wanted)]


def _product(ring: NumberField, a: FractionalIdeal) -> list[object]:
    """Return x and exponents with a = x·∏P^e, where P runs through S."""
    x, exponents = ring.class_group().factors(a)
    return [x.field.coordinates(x), list(map(int, exponents))]
