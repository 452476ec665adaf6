"""Diagonal forms without zeros, shown by residue forms (T. A. Springer, Indagationes Math. 17 (1955)).

At a discrete place with residue field k of characteristic not 2, a diagonal form is p + π·q with units as
coefficients. It has no zero if the residues of p and q have none over k.
"""

from __future__ import annotations

from collections.abc import Sequence

from hfield.core.product import Scalar
from hfield.errors import UndecidedError
from hfield.fields.base.ring import Ring
from hfield.fields.quadratic_forms.global_field import global_field


def no_zero(F: Ring, form: Sequence[Scalar]) -> str | None:
    """Return the reason why Σ cₙ·xₙ² has only the zero 0; None if residues, signs and squares do not show it.

    >>> from hfield import ring
    >>> F = ring("QQ(x,y)")
    >>> no_zero(F, [F(1), F(1), F("x"), F("y")])
    'at x its residue forms are <1, 1, y> and <1>; over QQ(y), at inf its residue forms are <1, 1> and <1>'
    """
    if F.characteristic == 2:
        return None
    if len(form) < 2:
        return ""
    if len(form) == 2:
        return "" if not F.is_square(-form[0] * form[1]) else None
    field = global_field(F)
    if field is None:
        return None
    if field.is_anisotropic(form):
        return ""
    for where, k, *parts in field.residue_forms(form):
        found = []
        for part in parts:
            try:
                reason = no_zero(k, part)
            except UndecidedError:
                reason = None
            if reason is None:
                break
            found.append(reason)
        else:
            shown = " and ".join(f"<{', '.join(map(k.text, part))}>" for part in parts if part)
            inside = "; ".join(f"over {k.name}, {reason}" for reason in found if reason)
            forms = "its residue forms are" if all(parts) else "its residue form is"
            return f"at {where} {forms} {shown}" + (f"; {inside}" if inside else "")
    return None
