"""Storage whose operations are Python functions, generated from the straight-line program at the
first call.
"""

from __future__ import annotations

import re
from abc import abstractmethod
from collections.abc import Callable
from functools import lru_cache, partial
from textwrap import indent
from typing import TYPE_CHECKING, Any

from hfield.core.product import Constants
from hfield.core.straight_line import Program, arithmetic_text
from hfield.errors import shorten
from hfield.fields.base.storage.base import H, S, Storage

if TYPE_CHECKING:
    from collections.abc import Sequence

    from hfield.fields.base.ring import Ring

LARGE = 2**256  # from about here on flint's integers multiply faster than Python's
MADE = (
    "conjugate",
    "difference",
    "inverse",
    "multiple",
    "negative",
    "norm",
    "product",
    "sum",
    "trace",
)


class Compact(Storage[H, S]):
    """A storage whose operations are compiled from the source text that :meth:`source` returns for each.

    Algebras whose constants agree in which are 0, 1 and −1 share the source text and the compiled code; all
    other constants are referred to by name.
    """

    __slots__ = (*MADE, "is_unique")  # slots, for Python looks these up fastest

    conjugate: Callable[[H], H]
    difference: Callable[[H, H], H]
    inverse: Callable[[H], H | None]
    multiple: Callable[[H, tuple[object, ...]], H]
    negative: Callable[[H], H]
    norm: Callable[[H], S]
    product: Callable[[H, H], H]
    sum: Callable[[H, H], H]
    trace: Callable[[H], S]

    def __init__(self, ring: Ring, constants: Constants) -> None:
        super().__init__(ring, constants)
        self.is_unique = True
        for name in MADE:
            setattr(self, name, partial(self._first_call, name))

    def read(self, values: tuple[object, ...]) -> H:
        """Encode four values that the ring reads; ints have a fast path."""
        w, x, y, z = values
        if type(w) is type(x) is type(y) is type(z) is int:
            return self.whole(w, x, y, z)
        return super().read(values)

    def whole(self, w: int, x: int, y: int, z: int) -> H:
        """Encode four ints."""
        return super().read((w, x, y, z))

    def equal(self, p: H, q: H) -> bool:
        """Return whether p = q."""
        return bool(p == q)

    @abstractmethod
    def source(self, operation: str) -> str:
        """Return the source text of a Python function, named like the operation, on stored values."""

    @abstractmethod
    def names(self) -> dict[str, object]:
        """Return the values of the free names in the source text."""

    def explain(self, operation: str) -> str:
        """Return the source text of an operation, preceded by lines on the stored values and the named
        constants.
        """
        source = self.source(operation)
        values = [
            f"{name} = {shorten(value)}"
            for name, value in self.names().items()
            if re.fullmatch(r"[abtmn](_\d+)?", name) and re.search(rf"\b{name}\b", source)
        ]
        head = [(type(self).__doc__ or "").partition("\n")[0], ", ".join(values)]
        return "\n".join([*(f"# {line}" for line in head if line), source])

    def _first_call(self, operation: str, *operands: object) -> object:
        made = getattr(self, operation)
        if isinstance(made, partial):  # nobody stored the function from before the first call
            names = self.names()
            made = _factory(operation, self.source(operation), tuple(names))(**names)
            setattr(self, operation, made)
        return made(*operands)


@lru_cache(maxsize=1024)
def _factory(name: str, source: str, free: tuple[str, ...]) -> Callable[..., Callable[..., object]]:
    """Return a function that makes the source text a closure over the values of its free names.

    Closure variables are looked up faster than globals, and algebras share the compiled code.
    """
    text = f"def make({', '.join(free)}):\n{indent(source, '    ')}\n    return {name}\n"
    namespace: dict[str, Any] = {}
    exec(compile(text, f"<{name} of quaternions>", "exec"), namespace)
    make: Callable[..., Callable[..., object]] = namespace["make"]
    return make


def function(name: str, operands: dict[str, str], lines: list[str]) -> str:
    """Return the source text of a function that unpacks its operands, given as ``{"p": "w1, x1, y1,
    z1"}``.
    """
    head = f"def {name}({', '.join(operands)}):"
    unpacked = [f"{parts} = {operand}" for operand, parts in operands.items()]
    return "\n".join([head, *(f"    {line}" for line in unpacked + lines)])


def statements(
    program: Program,
    outputs: tuple[str, ...],
    write: Callable[[str, Sequence[str]], str] = arithmetic_text,
) -> list[str]:
    """Return a program as assignments to its named outputs."""
    assigned, values = program.expressions(write)
    return [f"{n} = {text}" for n, text in [*assigned, *zip(outputs, values, strict=True)]]
