"""Labels of orders over ℤ: texts that are equal if and only if the orders are isomorphic.

The label of a definite order is its reduced ternary form. Orders are isomorphic if and only if their ternary
forms are equivalent up to sign (Voight, *Quaternion Algebras*, theorem 22.1.1). The form of a definite order
is taken to be positive, and equivalent positive forms have the same reduced form. The label of an Eichler
order of level N in an indefinite algebra of discriminant D is ``D.N``: by strong approximation the order is
unique up to conjugation (Voight, theorem 28.2.11). Other orders have no label yet.
"""

from __future__ import annotations

import re
from collections.abc import Callable

from hfield.algebra.quaternion import Parent, Quaternion
from hfield.errors import LatticeError, MixedParentsError, NotationError, UndecidedError, shorten
from hfield.fields.rationals.ring import QQ
from hfield.fields.rationals.whole_numbers import fraction
from hfield.orders.basis import AlgebraBasis, basis_of
from hfield.orders.generated_orders import checked_ring
from hfield.orders.invariants import is_eichler, level
from hfield.orders.lattice_values import LatticeValue, spanned
from hfield.orders.pseudo_bases import basis_modulo_numbers
from hfield.orders.standard_orders import eichler_order
from hfield.orders.ternary_forms import TernaryForm, form_of, read_form
from hfield.orders.validation import expect_rational

_EXPECTED = "a label is a ternary form such as 'x²+y²+3·z²+y·z', or D.N such as '6.5'"


def expect_labels(ambient: AlgebraBasis) -> None:
    """Raise :class:`UndecidedError` over a base whose orders have no labels yet."""
    if ambient.degree > 1 or ambient.base.is_polynomial:
        raise _no_label(f"of orders over {ambient.base.symbol}")


def reduced_form(order: LatticeValue) -> TernaryForm:
    """Return the reduced ternary form of a definite order over ℤ."""
    base, algebras = order.ambient.base, type(order.algebra)
    form = form_of(basis_modulo_numbers(order), algebras)
    numbers = map(base.as_rational, map(base.inside, form.coefficients))
    return TernaryForm(QQ, numbers, algebras).reduced()


def label(order: LatticeValue) -> str:
    """Return the label. Raises :class:`UndecidedError` for an order without a label."""
    ambient = order.ambient
    expect_labels(ambient)
    if ambient.definite:
        return str(reduced_form(order))
    if not is_eichler(order):
        raise _no_label("of indefinite orders that are not Eichler orders")
    norm = ambient.base.absolute_norm
    return f"{norm(ambient.discriminant)}.{norm(level(order))}"


def order_of_label(algebra: Parent, text: str) -> LatticeValue:
    """Return an order of an algebra with this label.

    Raises :class:`NotationError` for an invalid label, :class:`MixedParentsError` for the label of an order
    in another algebra, and :class:`UndecidedError` over fields other than ℚ.
    """
    ambient = basis_of(algebra)
    expect_rational(ambient.base, _no_label(f"of orders over {ambient.base.symbol}"))
    if not isinstance(text, str):
        raise NotationError(f"{shorten(repr(text))} is not a text: {_EXPECTED}")
    indefinite = re.fullmatch(r"\s*([0-9]{1,4000})\.([0-9]{1,4000})\s*", text)
    if indefinite:
        return _eichler(algebra, int(indefinite[1]), int(indefinite[2]))
    try:
        form = read_form(text, QQ, type(algebra))
    except NotationError as error:
        raise NotationError(f"{error.reason}; {_EXPECTED}", text, error.position) from None
    except LatticeError as error:
        raise NotationError(f"{error}; {_EXPECTED}") from None
    if not (form.is_definite() and fraction(form(1, 0, 0)) > 0):
        raise NotationError(
            f"{form} is not positive, and labels are positive forms: an indefinite Eichler order has the "
            "label D.N"
        )
    order = form.order()
    onto: Callable[[Quaternion], Quaternion] | None = order.algebra.isomorphism(algebra)
    if onto is None:
        raise MixedParentsError(
            f"the order with the form {form} lies in an algebra of discriminant "
            f"{order.value.ambient.discriminant}, and {shorten(algebra)} has the discriminant "
            f"{ambient.discriminant}{' and is indefinite' * (not ambient.definite)}"
        )
    return checked_ring(spanned(algebra, [onto(q) for q in order.basis]))


def _eichler(algebra: Parent, discriminant: int, number: int) -> LatticeValue:
    """Return the Eichler order of an indefinite algebra with this label."""
    ambient = basis_of(algebra)
    if ambient.definite:
        raise MixedParentsError(
            f"{discriminant}.{number} is the label of an indefinite order, but {shorten(algebra)} is "
            "definite: there the label is a ternary form, such as that of eichler_order(N).label()"
        )
    if ambient.discriminant != discriminant:
        raise MixedParentsError(
            f"an order with the label {discriminant}.{number} lies in an algebra of discriminant "
            f"{discriminant}, and {shorten(algebra)} has the discriminant {ambient.discriminant}"
        )
    return eichler_order(algebra, number)


def _no_label(which: str) -> UndecidedError:
    return UndecidedError(
        f"labels {which} are not yet given: definite orders and indefinite Eichler orders over ℤ have them"
    )
