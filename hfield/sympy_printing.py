"""Methods that sympy's printers call, for classes that print themselves."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from sympy.printing.pretty.stringpict import prettyForm


class PrintedBySympy:
    """A class with ``__str__``, ``__repr__`` and ``_repr_latex_``, which sympy uses to print its objects.

    >>> import sympy
    >>> from hfield import H
    >>> sympy.latex([H("QQ")(1, 2, 0, 0)]), sympy.sstr(H("QQ")("1/2"))
    ('\\\\left[ 1 + 2i\\\\right]', '1/2')
    """

    __slots__ = ()

    def _repr_latex_(self) -> str | None:
        return None

    def _latex(self, printer: object) -> str:
        found = self._repr_latex_()
        return rf"\mathtt{{\text{{{self}}}}}" if found is None else found.strip("$")

    def _sympystr(self, printer: object) -> str:
        return str(self)

    def _sympyrepr(self, printer: object) -> str:
        return str(self)

    def _pretty(self, printer: object) -> prettyForm:
        from sympy.printing.pretty.stringpict import prettyForm

        return prettyForm(repr(self))
