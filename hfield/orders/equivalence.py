"""Decide whether two ideals are equivalent, over any base, and find an element that maps one onto the other.

``J = I·c`` means that c lies in ``I⁻¹·J`` and that N(c) generates ``N(J)/N(I)``. Up to squares of units there
are finitely many such norms. In a totally definite algebra an element of such a norm is a vector of least
possible length in a positive definite lattice. A complete enumeration of these vectors finds an element or
proves that there is none (Kirschmer and Voight, *SIAM J. Comput.* 39, 2010). In other algebras strong
approximation decides. If exactly one infinite place splits, and it is real, an element is searched for first:
over ℚ among short vectors of a majorant of the norm form, and then, over every base, among short vectors of
the definite forms of points of the hyperbolic plane.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from itertools import islice

from hfield.algebra.quaternion import Quaternion
from hfield.errors import UndecidedError
from hfield.fuchsian.search import element_of_norm, split_order
from hfield.orders import certificates, enumeration, hermite
from hfield.orders.base import Base
from hfield.orders.base_values import BaseIdeal, BaseNumber
from hfield.orders.invariants import has_all_unit_norms
from hfield.orders.kernels import ideal_products
from hfield.orders.lattice_values import (
    LatticeValue,
    colon,
    conjugate,
    index,
    is_locally_principal,
    times_ideal,
)
from hfield.orders.short_elements import element_of_norms, multiple_of_content
from hfield.verdicts import Verdict

TRIED = 4_000
"""Short vectors tried for an element of given norm in an indefinite algebra, before others."""
STRONG_APPROXIMATION = (
    "Eichler's theorem, from strong approximation: in an algebra that splits at an infinite place, ideals of "
    "an order whose local units have all unit norms are equivalent where the quotient of their norms has a "
    "generator that is positive where the algebra ramifies (Voight, Quaternion Algebras, chapter 28)"
)


def equivalence(
    first: LatticeValue, second: LatticeValue, order: LatticeValue, side: str
) -> Verdict[Quaternion]:
    """Return c with ``second = first·c`` (left ideals) or ``c·first`` (right ideals), or the reason why not.

    Both are ideals of ``order``. Raises :class:`UndecidedError` in an indefinite algebra if strong
    approximation does not decide.
    """
    invertible = is_locally_principal(first, order) and is_locally_principal(second, order)
    norm, between = second.norm / first.norm, None
    if invertible or index(first, second) == norm * norm:
        between = _between(first, second, order, side, invertible)
        found = element_generating(between, norm, order, invertible)
    else:
        found = Verdict(
            False, "the index of one in the other is not the square of the quotient of their norms"
        )
    claim = partial(certificates.of_equivalence, side, first, second, between, found)
    return replace(found, make_claim=claim)


def _between(
    first: LatticeValue, second: LatticeValue, order: LatticeValue, side: str, invertible: bool
) -> LatticeValue:
    """Return the lattice of all c with first·c in second, or c·first for right ideals."""
    if not invertible:
        return colon(second, first, "left" if side == "right" else "right")
    bar = conjugate(first)
    ambient = first.ambient
    pair = (second, bar) if side == "right" else (bar, second)
    found = ideal_products.product(*pair, order)
    return times_ideal(found, ambient.base.inverse(first.norm))


def element_generating(
    lattice: LatticeValue, norm: BaseIdeal, order: LatticeValue, invertible: bool = True
) -> Verdict[Quaternion]:
    """Return an element of a lattice whose norm generates an ideal, or the reason why there is none.

    ``invertible`` means that the lattice is locally principal; ``order`` is one of its orders. Raises
    :class:`UndecidedError`.
    """
    ambient, base = lattice.ambient, lattice.ambient.base
    norms = base.generators(norm, ambient.ramified_real_places)
    if not norms:
        kind = (
            "totally positive generator"
            if ambient.definite
            else "generator, positive where the algebra ramifies,"
        )
        return Verdict(False, f"the norm would be a {kind} of {norm}, which has none")
    found = None
    if ambient.definite:
        found = element_of_norms(lattice, norms)
    elif ambient.is_fuchsian:
        found = _among_short(lattice, norms) or _in_the_plane(lattice, norms, order)
    if found is not None:
        return Verdict(True, "the element is multiplied out", found)
    shown = _norms_text(base, norms)
    if ambient.definite:
        return Verdict(False, f"no element of {shown} lies between them")
    reason = f"no element of {shown} was found among short ones"
    if not (invertible and has_all_unit_norms(order)):
        raise UndecidedError(
            f"whether ideals of an indefinite algebra are equivalent is not decided: {reason}, and strong "
            "approximation decides for invertible ideals of orders with Eichler symbols 1 and −1"
        )
    return Verdict(True, f"{reason}, but there is one", theorem=STRONG_APPROXIMATION)


def _norms_text(base: Base, norms: Sequence[BaseNumber]) -> str:
    shown = ", ".join(base.ring.text(base.outside(x)) for x in norms)
    return f"norm {shown}" if len(norms) == 1 else f"a norm among {shown}, up to squares of units,"


def _among_short(lattice: LatticeValue, norms: Sequence[BaseNumber]) -> Quaternion | None:
    """Return an element of norm ±n if there is one among short vectors for a majorant of the norm."""
    ambient = lattice.ambient
    if not ambient.has_majorant:
        return None
    wanted = multiple_of_content(lattice, abs(ambient.base.trace(norms[0])))
    rows, _ = lattice.reduced
    size = hermite.tuples(rows * ambient.majorant * rows.transpose())
    bound, tried = max(size[n][n] for n in range(4)), 0
    while tried < TRIED:
        vectors = enumeration.short_vectors(size, bound)
        tried = 0
        for tried, (x, _) in enumerate(islice(vectors, TRIED), 1):  # noqa: B007
            row = hermite.combination(x, rows)
            if abs(lattice.multiple(row)) == wanted:
                return lattice.element(row)
        bound *= 2
    return None


def _in_the_plane(
    lattice: LatticeValue, norms: Sequence[BaseNumber], order: LatticeValue
) -> Quaternion | None:
    """Return an element of one of these norms that is short as seen from some point of the plane."""
    split = split_order(order)
    basis = lattice.elements(lattice.short_rows)
    return next((q for x in norms if (q := element_of_norm(split, basis, x)) is not None), None)
