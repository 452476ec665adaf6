"""Lay out the page about an algebra."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import partial
from typing import TYPE_CHECKING

from hfield.algebra.maps import matrix_text
from hfield.core.product import Scalar
from hfield.errors import shorten
from hfield.fields.base.printing import is_sum, number_text, parentheses
from hfield.fields.base.ring import Ring
from hfield.fields.quadratic_forms.global_field import global_field
from hfield.latex import words
from hfield.notation import element_text
from hfield.presenting import AnswerSection, Facts, LayoutBlock, hanging

if TYPE_CHECKING:
    from hfield.algebra import QuaternionAlgebra
    from hfield.description.summary import Description

WIDTH = 100  # if no page width is given


def parts(d: Description) -> list[AnswerSection]:
    """Return the page about an algebra in sections: title, multiplication table, and facts."""
    A = d.algebra
    over = A.ring.in_words()
    return [
        LayoutBlock(
            partial(_title, A.name, over),
            lambda: rf"\[ {A.latex()} \]" + f"\n\n\\noindent over {words(over)}.",
        ),
        LayoutBlock(partial(_relations, d.relations)),
        LayoutBlock(partial(_table, A), lambda: rf"\[ {A.table_text('latex')} \]"),
        *(Facts(facts, title=title) for title, facts in _facts(d) if facts),
    ]


def _relations(relations: Sequence[str], width: int) -> list[str]:
    """Lay out the relations in lines, without breaking a relation."""
    whole = (shorten(relation, width // 2).replace(" ", "\0") for relation in relations)
    return [line.replace("\0", " ") for line in hanging("  ", ",   ".join(whole), width)]


def _table(A: QuaternionAlgebra, width: int) -> list[str]:
    table = [f" {line}" for line in A.table_text("unicode").splitlines()]
    if max(map(len, table)) <= width:
        return table
    return hanging("  ", "The table is wider than this page; `hfield table` prints it.", width)


def _facts(d: Description) -> list[tuple[str, list[tuple[str, str]]]]:
    """Return the facts in three sections, each a title and pairs of a label and a text."""
    base = "Base field" if d.algebra.ring.is_field else "Base ring"
    return [(base, _field(d)), ("Algebra", _algebra(d)), ("Places", _places(d))]


def _title(name: str, ring: str, width: int) -> list[str]:
    """Lay out the first line, which describes the base ring, with a rule below."""
    over = shorten(f"over {ring}", width - 20)
    title = f"{shorten(name, width - len(over) - 2)}  {over}"
    return [title, "─" * len(title)]


def _field(d: Description) -> list[tuple[str, str]]:
    F = d.algebra.ring
    size = "" if F.order is None else f", {F.order} elements"
    rows = [("name", f"{F.name}, characteristic {F.characteristic}{size}")]
    modulus = getattr(F, "modulus", None)
    if isinstance(modulus, str):
        rows.append(("modulus", f"{modulus} ({F.modulus_origin})"))  # type: ignore[attr-defined]
    if not F.is_exact:
        rows.append(("inexact", "floats: nothing is proved over this ring"))
    elif F.is_field:
        rows.append(("level", str(F.level)))
    if d.integers is not None:
        shown = (
            f"{_lattice(F, d.integers)}, discriminant {number_text(F.discriminant(), 'unicode')}"  # type: ignore[attr-defined]
        )
        rows.append(("integers", shown))
    elif "integers" in d.undecided:
        rows.append(("integers", _undecided(d, "integers")))
    return rows


def _lattice(F: Ring, basis: Iterable[Scalar]) -> str:
    """Write the lattice spanned over ℤ by elements of a number field."""
    return f"ℤ⟨{', '.join(F.text(x, 'unicode') for x in basis)}⟩"


def _algebra(d: Description) -> list[tuple[str, str]]:
    F = d.algebra.ring
    rows = []
    if d.normal_form is not None:
        rows.append(("isomorphic to", f"{d.normal_form}, {d.substitution}"))
    if _is_hamilton(d):
        rows.append(("known as", f"H({F.name}), Hamilton's quaternions over {F.name}"))
    if d.commutative is None:
        rows.append(("commutative", _undecided(d, "commutative")))
    else:
        rows.append(("commutative", "yes" if d.commutative else "no"))
    rows.append(("centre", _span(d, "center", d.center)))
    if d.radical is not None or "radical" in d.undecided:
        rows.append(("radical", _span(d, "radical", d.radical)))
    if d.central_simple is not None:
        degenerate = "no, it is degenerate: (t² + 4a)·b = 0"
        rows.append(("central simple", "yes" if d.central_simple else degenerate))
    elif "central simple" in d.undecided:
        rows.append(("central simple", _undecided(d, "central simple")))
    rows.append(("derivations", _derivations(d)))
    rows.append(("division algebra", _division(d)))
    if d.assumes:
        rows.append(("cited", "; ".join(d.assumes)))
    if d.zero_norm is not None:
        rows.append(("zero norm", f"N({d.zero_norm.text('unicode')}) = 0"))
    elif d.division is None or "zero_norm_element" in d.undecided:
        rows.append(("zero norm", _undecided(d, "zero_norm_element", "division")))
    else:
        rows.append(("zero norm", "only 0 has norm 0" if d.division or d.reason else "not known"))
    if d.splitting is not None:
        rows.append(("splitting", f"isomorphic to M₂({F.name}), checked by multiplying out:"))
        for name, matrix in (("i", d.splitting.i), ("j", d.splitting.j)):
            rows.append(("", f"{name} ↦ {matrix_text(F, matrix, 'unicode')}"))
    elif "splitting" in d.undecided:
        rows.append(("splitting", _undecided(d, "splitting")))
    return rows


def _is_hamilton(d: Description) -> bool:
    F, c = d.algebra.ring, d.algebra.constants
    return all(F.key(x) == F.key(F(n)) for x, n in zip(c, (-1, 0, -1), strict=True))


def _division(d: Description) -> str:
    if d.division is None:
        return _undecided(d, "division")
    level = d.algebra.ring.level
    reason = d.reason.replace(str(level), str(level.value))  # the base field's rows give its reason
    if d.division:
        return f"yes: {reason}" if reason else "yes"
    if not d.algebra.ring.is_field:
        return f"no: {d.algebra.ring.no_field}, and its scalars need inverses"
    if d.splitting is None and "splitting" in d.undecided:
        return "no"
    return f"no: {reason}" if reason else "no: it has zero divisors"


def _derivations(d: Description) -> str:
    if d.derivations is None or d.center is None:
        return _undecided(d, "derivations", "center")
    if not d.algebra.ring.is_field:
        return f"{d.derivations} generators"
    inner = 4 - len(d.center)
    which = (
        "all inner" if inner == d.derivations else f"of which the inner ones have dimension {inner}"
    )
    return f"dimension {d.derivations}, {which}"


def _span(d: Description, name: str, basis: object) -> str:
    if basis is None:
        return _undecided(d, name)
    assert isinstance(basis, tuple)
    texts = [element_text(d.algebra.ring, q.coordinates, "unicode", "e") for q in basis]
    if not texts:
        return "0"
    if not d.algebra.ring.is_field:
        return f"generated by {', '.join(texts)}"
    return f"spanned by {', '.join(texts)} (dimension {len(texts)})"


def _undecided(d: Description, *names: str) -> str:
    return f"undecided: {next((d.undecided[n] for n in names if n in d.undecided), 'not tried')}"


def _number(d: Description) -> str:
    return str(d.units) if d.units is not None else _undecided(d, "units")


def _places(d: Description) -> list[tuple[str, str]]:
    if "ramified_places" in d.undecided:
        return [("ramified at", _undecided(d, "ramified_places"))]
    if d.ramified is None:
        return []
    rows = [("ramified at", ", ".join(map(str, d.ramified)) or _nowhere(d))]
    value = d.discriminant_json()
    shown = " · ".join(value) or "1" if isinstance(value, list) else value
    rows.append(("discriminant", str(shown)))
    if d.order is not None and d.algebra.is_over_number_field:
        rows.append(("maximal order", f"the direct sum of these, discriminant {shown}:"))
        F = d.algebra.ring
        for ideal, q in d.order.pseudo_basis():
            text = element_text(F, q.coordinates, "unicode")
            text = parentheses(text, "unicode") if is_sum(text) else text
            rows.append(("", f"{_lattice(F, ideal)} · {text}"))
    elif d.order is not None:
        basis = ", ".join(str(q) for q in d.order.basis)
        definite = "inf" in d.ramified
        count = f"{_number(d)} units" if definite else "infinitely many units"
        rows.append(
            ("maximal order", f"ℤ⟨{basis}⟩, discriminant {d.order.discriminant()}, {count}")
        )
    elif "maximal_order" in d.undecided:
        rows.append(("maximal order", _undecided(d, "maximal_order")))
    return rows


def _nowhere(d: Description) -> str:
    """Return the text for an algebra without ramified places; over functions over ℚ it may come from the
    constants.
    """
    field = global_field(d.algebra.ring)
    if field is None or field.splits_if_unramified:
        return "no place"
    return "no prime divisor: without a residue, what is left is an algebra over the constants"
