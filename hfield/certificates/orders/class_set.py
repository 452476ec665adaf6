"""``ideal-classes{O; h}``: the right ideal classes of an order over ℤ_K in a totally definite algebra.

As over ℤ: with an ideal I go the lattices x⁻¹·I, for the x in I with the least Tr(N(x)/νu). Here ν·a is the
norm of I, with ν totally positive and a one of some ideals in different narrow classes, and u any of the
totally positive units, of which those that differ by squares do not matter (docs/trust.md).
"""

from fractions import Fraction
from math import lcm
from typing import Any

from hfield.certificates.finding import Finding
from hfield.certificates.glossary import BY_MASS, FIELD, MASS_OVER_FIELDS, SIEGEL
from hfield.certificates.number_fields.classes import Element, field_of
from hfield.certificates.number_fields.enumeration import short_vectors
from hfield.certificates.number_fields.integers import Factors
from hfield.certificates.number_fields.lattices import (
    Frame,
    Lattice,
    Row,
    need_locally_principal,
    traces,
)
from hfield.certificates.number_fields.local_types import mass
from hfield.certificates.number_fields.matrices import (
    Key,
    hermite,
    rational_rows,
    reduced,
    times,
    unit,
)
from hfield.certificates.number_fields.narrow import Narrow
from hfield.certificates.rejection import a_list, an_integer, an_object, reject
from hfield.certificates.scalars.matrices import inverse_matrix
from hfield.certificates.statement import Setting
from hfield.certificates.work import charge


def ideal_classes(
    parts: tuple[str, ...], setting: Setting, verdict: str, evidence: object
) -> Finding:
    """The order has so many classes of locally principal right ideals."""
    if verdict != "proved":
        reject(f"a set of classes does not show that this is {verdict}")
    data = an_object(evidence, "kind units fundamental primes classes", "the evidence", "narrow")
    if data["kind"] != "ideal-classes":
        reject("what shows a number of classes is evidence of the kind 'ideal-classes'")
    narrow = Narrow(field_of(setting), data["units"], data["fundamental"])
    base = Frame(setting, narrow.s.integers)
    factors = Factors(base.integers, data["primes"])
    classes = a_list(data["classes"], "classes", 1)
    if len(classes) != int(parts[1]):
        reject(f"{len(classes)} classes are given, which is not the number that is stated")
    order = base.order(parts[0])
    norms = _narrow_classes(narrow, data.get("narrow"))
    seen: dict[tuple[int, Key], int] = {}
    total = Fraction(0)
    for number, value in enumerate(classes):
        entry = dict(an_object(value, "den rows norm", "an ideal", "narrow"))
        nu, kind = (
            narrow.s.given(entry.pop("norm")),
            an_integer(entry.pop("narrow", 0), "a number", 0),
        )
        if kind >= len(norms):
            reject("an ideal has the norm of a narrow class that is not given")
        ideal = base.given(entry)
        inverse = narrow.need_totally_positive(nu)
        x, e = norms[kind]
        if not narrow.is_quotient(base.field.mul(nu, x), e, ideal.norm, _whole(base)):
            reject("the norm of an ideal is another one")
        need_locally_principal(ideal, order, "right")
        keys, units = _keys(narrow, ideal, inverse)
        for key in keys:
            if seen.setdefault((kind, key), number) != number:
                reject(f"the ideals {seen[kind, key]} and {number} are in one class")
        total += Fraction(1, units)
    if total != mass(order, factors) * narrow.order:
        reject("these classes do not have the mass of all classes")
    return Finding(FIELD, BY_MASS).citing(*narrow.s.cites, SIEGEL, MASS_OVER_FIELDS)


def _whole(base: Frame) -> Key:
    return 1, tuple(unit(base.n, k) for k in range(base.n))


def _narrow_classes(narrow: Narrow, value: object) -> list[tuple[Element, list[int]]]:
    """Read ideals, as products of primes in S, that lie in different narrow classes; by default that of 1."""
    if value is None:
        return [(narrow.field.one, [0] * len(narrow.s.S))]
    found = [narrow.read(x) for x in a_list(value, "ideals of the narrow classes", 1)]
    for k, (x, e) in enumerate(found):
        for y, f in found[:k]:  # signs of a quotient are those of the product
            if narrow.is_principal(
                narrow.field.mul(x, y), [a - b for a, b in zip(e, f, strict=True)]
            ):
                reject("two norms are in one narrow class")
    return found


def _keys(narrow: Narrow, ideal: Lattice, inverse: Any) -> tuple[set[Key], int]:
    """Return the x⁻¹·I, and the index of the units of the field in those of the left order of I."""
    base = ideal.base
    ways = []
    for u in narrow.units:  # their inverses differ from them by squares
        scale = base.field.mul(inverse, u)
        gram = ideal.form(traces(base, scale))
        # each over the same denominator, so that lengths of different forms can be compared
        den = lcm(*(w.denominator for w in traces(base, scale)))
        ways.append((scale, gram, den))
    least = min(Fraction(gram[a][a], den) for _, gram, den in ways for a in range(base.size))
    found: list[tuple[Row, Any]] = []
    for scale, gram, den in ways:
        bound = int(least * den)
        for x, value in short_vectors(gram, bound):
            size = Fraction(value, den)
            if size < least:
                found, least = [], size
            if size == least:
                found.append((x, scale))
    counts: dict[tuple[Key, Row], int] = {}
    for x, scale in found:
        norm = ideal.norm_of(x)
        key = _divided(ideal, times([x], ideal.rows)[0], norm)
        part = base.integers.coordinates(scale)
        relative = key, (part[0], *base.integers.mul(norm, part[1]))
        counts[relative] = counts.get(relative, 0) + 1
    return {key for key, _ in counts}, next(iter(counts.values()))


def _divided(ideal: Lattice, x: Row, size: Row) -> Key:
    """Return x⁻¹·I = N(x)⁻¹·conj(x)·I; size is 2·N(x) in the integral basis, ``unit`` times too large."""
    base = ideal.base
    matrix = [[Fraction(c, 2 * ideal.unit) for c in line] for line in base.integers.matrix(size)]
    inverse = inverse_matrix(matrix)
    if inverse is None:
        reject("an element of norm 0 is not divided by")
    den, block = rational_rows(inverse)
    rows = times(ideal.rows, base.left(base.conjugate(x)))
    n = base.n
    divided = [
        tuple(c for k in range(4) for c in times([row[k * n : (k + 1) * n]], block)[0])
        for row in rows
    ]
    whole = base.scale * base.conjugate_scale * ideal.den * ideal.den * den
    charge(base.size**3)
    return reduced(whole, hermite(divided))


FORMS = {"ideal-classes": "[^;]+;[1-9][0-9]{0,4}"}
CHECKS = {"ideal-classes": ideal_classes}
