"""Store elements as numerators over one denominator: the common part of ℚ, number fields and F(t)."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Hashable
from typing import TYPE_CHECKING, Any, TypeAlias

from hfield.core.straight_line import FIRST, SECOND, parts, specialise_extension
from hfield.fields.base.storage.base import S
from hfield.fields.base.storage.compact import Compact, function, statements

FractionTuple: TypeAlias = tuple[Any, ...]
"""The numerators of w, x, y, z, and the denominator last."""

if TYPE_CHECKING:
    from typing_extensions import TypeVar

    T = TypeVar("T", bound=tuple[object, ...], default=FractionTuple)
else:
    from typing import TypeVar

    T = TypeVar("T")  # the type of such a tuple


class CommonDenominatorStorage(Compact[T, S]):
    """Storage of elements as coordinates over a common denominator, in lowest terms.

    A coordinate has n numerators, the coefficients of 1, s, …, sⁿ⁻¹; ``relation`` expresses sⁿ by these
    powers. The basis is scaled to i′ = m·i, j′ = k·j, so that the constants a′ = m²a, t′ = mt, b′ = k²b have
    no denominators; the algebra keeps its form, and the product its formula. ``pattern`` and ``relation`` are
    as in :func:`~hfield.core.straight_line.specialise_extension`.
    """

    inverted = [  # noqa: RUF012 - never changed
        "if d == 0:",
        "    return None",
        "w, x, y, z = w*d1, x*d1, y*d1, z*d1",
    ]
    pattern: tuple[tuple[str, ...], ...]
    relation: tuple[str, ...]

    @abstractmethod
    def fraction(self, s: S) -> tuple[object, ...]:
        """Return the numerators of an element of the ring over one denominator, in lowest terms."""

    @abstractmethod
    def settle(self, names: list[str]) -> list[str]:
        """Return code that returns the named numerators over d in lowest terms."""

    def value(self, names: list[str], denominator: str) -> list[str]:
        """Return code that returns the named numerators over a denominator as an element of the ring."""
        return [f"return element({', '.join(names)}, {denominator})"]

    def source(self, operation: str) -> str:
        """Return the source text of an operation on numerators over one denominator."""
        degree = len(self.relation)
        first, second, results = (
            [part for name in side for part in parts(name, degree)]
            for side in (FIRST, SECOND, "wxyz")
        )
        p = {"p": f"{', '.join(first)}, d1"}
        both = p | {"q": f"{', '.join(second)}, d2"}

        def formula(name: str, outputs: list[str]) -> list[str]:
            program = specialise_extension(name, self.pattern, self.relation)
            return statements(program, tuple(outputs))

        if operation == "product":
            body = [*formula("product", results), "d = d1*d2", *self.settle(results)]
            return function("product", both, body)
        if operation in ("sum", "difference"):
            body = _added("+" if operation == "sum" else "-", results, first, second)
            return function(operation, both, [*body, *self.settle(results)])
        if operation == "multiple":
            scalar = parts("w2", degree)
            body = [*formula("multiple", results), "d = d1*d2", *self.settle(results)]
            return function(operation, p | {"s": f"{', '.join(scalar)}, d2"}, body)
        if operation == "inverse" and (degree > 1 or not self.ring.is_field):
            return "def inverse(p):\n    return by_norm(p)"
        if operation == "inverse":
            body = [*formula("adjoint", [*results, "d"]), *self.inverted, *self.settle(results)]
            return function("inverse", p, body)
        if operation in ("norm", "trace"):
            norm = list(parts("s", degree))
            d = "d1*d1" if operation == "norm" else "d1"
            return function(operation, p, [*formula(operation, norm), *self.value(norm, d)])
        value = f"return {', '.join(results)}, d1"
        return function(operation, p, [*formula(operation, results), value])

    def names(self) -> dict[str, object]:
        """Return the names used in every source text; a field adds its constants and its reduction to lowest
        terms.
        """
        return {"by_norm": self._by_norm}

    def _by_norm(self, p: T) -> T | None:
        """Return the inverse, computed from the inverse of the norm in the ring."""
        stored: T | None = self.divided(self.conjugate(p), self.norm(p))
        return stored

    def scaled(self, p: T, s: S) -> T:
        """Return s·p for an element s of the ring."""
        stored: T = self.multiple(p, self.fraction(s))
        return stored

    def is_zero(self, p: T) -> bool:
        """Return whether p = 0."""
        return all(c == 0 for c in p[:-1])

    def key(self, p: T) -> Hashable:
        """Return p itself."""
        return p


def _added(sign: str, results: list[str], first: list[str], second: list[str]) -> list[str]:
    """Return code for the sum or difference of two fractions, not in lowest terms."""
    triples = list(zip(results, first, second, strict=True))
    return [
        "if d1 == d2:",
        *(f"    {r} = {u} {sign} {v}" for r, u, v in triples),
        "    d = d1",
        "else:",
        *(f"    {r} = {u}*d2 {sign} {v}*d1" for r, u, v in triples),
        "    d = d1*d2",
    ]
