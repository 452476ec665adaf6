"""The words of statements about orders over three kinds of base, and their checks.

Over ℚ: ``order{L; n}`` · ``order{L; n; maximal}`` · ``ideal{I; side; O; norm}`` ·
``equivalent{side; I; J}`` · ``isomorphic-orders{O; P}`` · ``embedding{O; d}`` ·
``embedding-orbits{O; d; n}`` · ``class-set{O; h}`` · ``dirichlet-domain{O; c; g | …}`` ·
``norm-one-group{O; genus; orders; cusps; g | …; words}`` · ``newforms{O; k; p,…; F: a,… | …}``, also with
signs, ``newforms{O; k; p,…; F: a,… | …; q,…; w,… | …}``. A lattice
is written as four rows of rational numbers, ``1,0,0,0 | 0,1,0,0 | 0,0,1,0 | 1/2,1/2,1/2,1/2``.

Over a number field: ``order-over-integers{O; n}`` · ``ideal-over-integers{I; side; O; n}``, n the absolute
norm of the reduced discriminant and of the reduced norm · ``equivalent-over-integers{side; I; J}`` ·
``isomorphic-over-integers{O; P}`` · ``unit-index{O; n}`` · ``ideal-classes{O; h}`` ·
``dirichlet-domain-over-integers{…}`` · ``norm-one-group-over-integers{…}`` · ``newforms-over-integers{…}``.
A lattice is written as a basis
over ℤ, of elements with four numbers of the field each.

Over the functions over a finite field: ``order-over-polynomials{O; n}`` ·
``ideal-over-polynomials{I; side; O; n}``, n the monic generators of reduced discriminant and norm ·
``equivalent-over-polynomials{side; I; J}`` · ``isomorphic-over-polynomials{O; P}`` ·
``unit-index-over-polynomials{O; n}`` · ``class-set-over-polynomials{O; h}``. A lattice is written as a basis
over the polynomials.
"""

from collections.abc import Callable
from functools import partial
from typing import TypeVar

from hfield.checker.check_result import CheckResult
from hfield.checker.language import Meaning
from hfield.checker.orders import embeddings, newforms, statements
from hfield.checker.orders.reading import Data, OverField, OverPolynomials, OverQ
from hfield.checker.orders.texts import (
    a_rational,
    a_side,
    elements_of,
    numbers_of,
    orbits_of,
    rows_of,
    signs_of,
    words_of,
)
from hfield.checker.rejection import an_object, kind_of, reject, shown
from hfield.checker.statement import Setting

B = TypeVar("B", OverQ, OverField, OverPolynomials)
Check = Callable[[B, tuple[str, ...]], CheckResult]
Evidence = dict[tuple[str, str], tuple[Check[B], str, str]]
"""Of a word and a verdict: the check, the keys of the evidence, and those that may be left out."""

NEWFORMS = "above neighbours operator modulus orbits"
OVER_Q: Evidence[OverQ] = {
    ("order", "proved"): (statements.is_order, "", ""),
    ("ideal", "proved"): (statements.is_ideal, "", ""),
    ("equivalent", "proved"): (statements.are_equivalent, "element", ""),
    ("equivalent", "refuted"): (statements.are_not_equivalent, "", "between"),
    ("isomorphic-orders", "proved"): (statements.are_isomorphic, "element", ""),
    ("isomorphic-orders", "refuted"): (statements.have_other_numbers, "", "trace norm bases"),
    ("embedding", "proved"): (embeddings.is_embedded, "element", ""),
    ("embedding", "refuted"): (embeddings.is_not_embedded, "", "basis prime"),
    ("embedding-orbits", "proved"): (embeddings.has_orbits, "center units elements", ""),
    ("class-set", "proved"): (statements.is_class_set, "classes", ""),
    ("dirichlet-domain", "proved"): (statements.is_domain, "", ""),
    ("norm-one-group", "proved"): (statements.is_group, "center units", ""),
    ("newforms", "proved"): (newforms.are_newforms, f"classes {NEWFORMS}", "signs"),
}
UNITS = "units fundamental"
OVER_FIELDS: Evidence[OverField] = {
    ("order-over-integers", "proved"): (statements.is_order, "basis", ""),
    ("ideal-over-integers", "proved"): (statements.is_ideal, "basis", ""),
    ("equivalent-over-integers", "proved"): (statements.are_equivalent, "basis element", ""),
    ("equivalent-over-integers", "refuted"): (
        statements.are_not_equivalent, UNITS, "quotient norm between"
    ),
    ("isomorphic-over-integers", "proved"): (statements.are_isomorphic, "basis element", ""),
    ("isomorphic-over-integers", "refuted"): (statements.have_no_images, "basis", "pair order"),
    ("unit-index", "proved"): (statements.has_units, f"{UNITS} order", ""),
    ("ideal-classes", "proved"): (statements.is_class_set, f"{UNITS} primes classes", "narrow"),
    ("dirichlet-domain-over-integers", "proved"): (statements.is_domain, "basis primes", ""),
    ("norm-one-group-over-integers", "proved"): (
        statements.is_group, "basis primes center units", ""
    ),
    ("newforms-over-integers", "proved"): (
        newforms.are_newforms, f"{UNITS} primes classes {NEWFORMS}", "narrow central signs"
    ),
}  # fmt: skip

OVER_POLYNOMIALS: Evidence[OverPolynomials] = {
    ("order-over-polynomials", "proved"): (statements.is_order, "", ""),
    ("ideal-over-polynomials", "proved"): (statements.is_ideal, "", ""),
    ("equivalent-over-polynomials", "proved"): (statements.are_equivalent, "element", ""),
    ("equivalent-over-polynomials", "refuted"): (
        statements.none_of_least_degree_carries, "between", ""
    ),
    ("isomorphic-over-polynomials", "proved"): (statements.are_isomorphic, "element", ""),
    ("isomorphic-over-polynomials", "refuted"): (statements.have_no_images, "", "pair order"),
    ("unit-index-over-polynomials", "proved"): (statements.has_unit_index, "order", ""),
    ("class-set-over-polynomials", "proved"): (statements.is_class_set, "primes classes", ""),
}  # fmt: skip


def _maximal(text: str) -> str:
    if text != "maximal":
        reject(f"an order is stated to be maximal, or nothing more; found {shown(text)!r}")
    return text


# How the parts of a word over ℚ are read; the last OPTIONAL of them may be left away together.
PARTS: dict[str, tuple[Callable[[str], object], ...]] = {
    "order": (rows_of, a_rational, _maximal),
    "ideal": (rows_of, a_side, rows_of, a_rational),
    "equivalent": (a_side, rows_of, rows_of),
    "isomorphic-orders": (rows_of, rows_of),
    "embedding": (rows_of, a_rational),
    "embedding-orbits": (rows_of, a_rational, a_rational),
    "class-set": (rows_of, a_rational),
    "dirichlet-domain": (rows_of, elements_of, elements_of),
    "norm-one-group": (rows_of, a_rational, numbers_of, a_rational, elements_of, words_of),
    "newforms": (rows_of, a_rational, numbers_of, orbits_of, numbers_of, signs_of),
}
OPTIONAL = {"order": 1, "newforms": 2}

_NUMBER, _WHOLE = "[1-9][0-9]{0,99}", "(0|[1-9][0-9]{0,9})"
_IDEAL = "[^;|,]+"
_LETTERS = "-?[1-9][0-9]{0,3}( +-?[1-9][0-9]{0,3})*"
# How the parts of a word over a number field or over polynomials are written, between semicolons.
FORMS = {
    "order-over-integers": f"[^;]+;{_NUMBER}",
    "ideal-over-integers": f"[^;]+;(left|right);[^;]+;{_NUMBER}(/{_NUMBER})?",
    "unit-index": f"[^;]+;{_NUMBER}",
    "equivalent-over-integers": "(left|right);[^;]+;[^;]+",
    "isomorphic-over-integers": "[^;]+;[^;]+",
    "ideal-classes": "[^;]+;[1-9][0-9]{0,4}",
    "dirichlet-domain-over-integers": "[^;]+;[^;]+;[^;]+",
    "norm-one-group-over-integers": f"[^;]+;{_WHOLE};(none|{_WHOLE}(,{_WHOLE})*);{_WHOLE};[^;]+;"
    f"(none|{_LETTERS}(,{_LETTERS})*)",
    "newforms-over-integers": "[^;]+;2;[^;]+;[^;]+(;[^;]+;[^;]+)?",
    "order-over-polynomials": f"[^;]+;{_IDEAL}",
    "ideal-over-polynomials": f"[^;]+;(left|right);[^;]+;{_IDEAL}",
    "equivalent-over-polynomials": "(left|right);[^;]+;[^;]+",
    "isomorphic-over-polynomials": "[^;]+;[^;]+",
    "unit-index-over-polynomials": f"[^;]+;{_NUMBER}",
    "class-set-over-polynomials": "[^;]+;[1-9][0-9]{0,4}",
}


def establish_order(
    word: str, parts: tuple[str, ...], setting: Setting, verdict: str, evidence: object
) -> CheckResult:
    """Check the evidence for a statement about orders."""
    kind, said = kind_of(evidence), (word, verdict)
    if kind == word and said in OVER_POLYNOMIALS:
        return _established(OVER_POLYNOMIALS[said], OverPolynomials, parts, setting, evidence)
    if kind == word and said in OVER_FIELDS:
        return _established(OVER_FIELDS[said], OverField, parts, setting, evidence)
    if kind == word and said in OVER_Q:
        order_meaning(word, parts)
        return _established(OVER_Q[said], OverQ, parts, setting, evidence)
    reject(f"evidence of the kind {shown(kind)!r} does not show that {word} is {verdict}")


def _established(
    shown_by: tuple[Check[B], str, str],
    reader: Callable[[Setting, Data], B],
    parts: tuple[str, ...],
    setting: Setting,
    evidence: object,
) -> CheckResult:
    check, keys, optional = shown_by
    data = an_object(evidence, f"kind {keys}", "the evidence", optional)
    return check(reader(setting, data), parts)


def order_meaning(word: str, parts: tuple[str, ...]) -> Meaning:
    """Return the meaning of a statement over ℚ, independent of notation; a basis is not changed."""
    readers = PARTS[word]
    if len(parts) not in (len(readers), len(readers) - OPTIONAL.get(word, 0)):
        reject(f"{word} has not {len(parts)} parts")
    return word, tuple(read(part) for read, part in zip(readers, parts, strict=False))


def need_order_meaning(word: str, parts: tuple[str, ...], setting: Setting) -> None:
    """Reject a statement over ℚ without a meaning."""
    order_meaning(word, parts)
    OverQ(setting, {})


CHECKS = {word: partial(establish_order, word) for word in FORMS}
"""The words over a number field and over polynomials."""
