"""From text to number field: ``QQ[s]/(s^3-2)``, ``QQ(root(2,3))``, ``QQ(sqrt(2),I)``, ``QQ(zeta7)+``."""

from __future__ import annotations

import re

from hfield.fields.base.ring import Ring, shared
from hfield.fields.base.variables import names_in
from hfield.fields.number_fields.ring import NumberField
from hfield.fields.number_fields.texts import NUMBER, ReducibleError
from hfield.syntax.brackets import is_balanced

_QUOTIENT = re.compile(r"QQ?\[([^\[\],]*)\]/\((.*)\)")
_REAL = re.compile(r"QQ?\(zeta_?(\d+|\(\d+\))\)\+")
_SPELLED = re.compile(r"QQ?\(((?:(?:sqrt|cbrt|root)\(|zeta[_(]?\d|I[,)]).*)\)")
_SUM = re.compile(rf"QQ?\(([^,]*(?:{NUMBER})[^,]*)\)")


def read_number_field(s: str) -> Ring | None:
    """Return the number field other than ℚ(√d) that a text without spaces names; None for other texts.

    ``QQ[x]/(f)`` with a reducible f in x is not read either. Raises :class:`RingError`.
    """
    if m := _QUOTIENT.fullmatch(s):
        try:
            return shared(NumberField, m[2], m[1])
        except ReducibleError:
            if m[1] not in names_in(m[2]):
                raise
            return None
    if _REAL.fullmatch(s) or any(
        (m := form.fullmatch(s)) and is_balanced(m[1]) and not _is_quadratic(m[1])
        for form in (_SPELLED, _SUM)
    ):
        from hfield.fields.number_fields.spelled_names import spelled

        return shared(spelled, s)
    return None


def _is_quadratic(text: str) -> bool:
    """Return whether a text is a single square root, so that its field is quadratic."""
    m = re.fullmatch(r"sqrt\((.*)\)", text)
    return text == "I" or (m is not None and is_balanced(m[1]))
