"""The setting of a statement: a field, or all fields, and the structure constants."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache
from typing import TYPE_CHECKING

from hfield.errors import (
    CoercionError,
    HFieldError,
    NotationError,
    NotInvertibleError,
    UndecidedError,
    shorten,
)
from hfield.fields.base.ring import Ring
from hfield.fields.names import RingName, ring
from hfield.notation import UNNAMED, split_algebra
from hfield.prover.evaluation.evaluator import Evaluator
from hfield.prover.evaluation.scalars import RingScalars
from hfield.prover.statements.language import BASIS, HAMILTON, QUATERNIONS, RESULT, generators
from hfield.prover.statements.printing import to_text
from hfield.prover.statements.trees import divides_in, substitute, walk
from hfield.syntax import Call, Index, Name, Node, parse, weight

if TYPE_CHECKING:
    from hfield.algebra.structure_algebra import StructureAlgebra


MAX_CONSTANT_WEIGHT = 2_000


@dataclass(frozen=True)
class Setting:
    """A field, or None for all fields, and the texts of ``(a, t, b)``.

    In these texts each partly known number of the field is one call (:meth:`Ring.named_constants`).

    ``letters`` are the names in the constants that are not generators of the field; they are scalar unknowns.
    ``table`` is the algebra of the statement if it is given by a table; then the constants are those of H,
    over which the coordinates are scalars.
    """

    field: Ring | None
    constants: tuple[str, str, str]
    letters: tuple[str, ...]
    table: StructureAlgebra | None = None

    @cached_property
    def trees(self) -> tuple[Node, Node, Node]:
        """The structure constants as syntax trees."""
        a, t, b = map(parse, self.constants)
        return a, t, b

    @cached_property
    def divides(self) -> bool:
        """Whether the structure constants contain a division, so that they may be undefined."""
        return any(map(divides_in, self.trees))

    @property
    def algebra(self) -> str:
        """The algebra as text, such as ``(-1,-1|QQ)`` or ``table(…|QQ)``."""
        return self.symbol if self.table is None else str(self.table)

    @property
    def symbol(self) -> str:
        """The quaternion algebra as text, such as ``(-1,-1|QQ)``, with F if no field is named."""
        a, t, b = (_spelled(text, self.field) for text in self.constants)
        field = UNNAMED if self.field is None else self.field.name
        if t == "0":
            return f"({a},{b}|{field})"
        return f"[{a},{b}|{field})" if t == "1" else f"[{a},{b},{t}|{field})"

    @property
    def is_hamilton(self) -> bool:
        """Whether the algebra is H(F)."""
        return self.constants == HAMILTON and self.table is None


def read_setting(field: RingName | None = None, algebra: str | None = None) -> Setting:
    """Read the field and the algebra from their texts.

    ``algebra`` may include the field, as in ``(-1,-3|QQ)``, or leave it open with the letter F, as in
    ``(a,b|F)``; None stands for H. Raises :class:`NotationError` if the two disagree.
    """
    named = None if field is None else ring(field)
    if algebra is None:
        return Setting(named, HAMILTON, ())
    return _read(named, algebra)


def put_letters(setting: Setting, values: Mapping[str, Node]) -> Setting:
    """Return the setting with the letters of its algebra replaced by terms."""
    if not setting.letters:
        return setting
    own = {name: node for name, node in values.items() if name in setting.letters}
    a, t, b = (to_text(substitute(tree, own)) for tree in setting.trees)
    left = tuple(name for name in setting.letters if name not in own)
    return replace(setting, constants=(a, t, b), letters=left)


@lru_cache(maxsize=256)
def _read(field: Ring | None, algebra: str) -> Setting:
    if algebra.lstrip().startswith("table("):
        from hfield.algebra.structure_algebra import StructureAlgebra

        table = StructureAlgebra.from_text(algebra)
        if field is not None and field != table.ring:
            raise NotationError(
                f"the algebra {shorten(algebra)} is over {table.ring.name}, the field is {field.name}"
            )
        return Setting(table.ring, HAMILTON, (), table)
    a, t, b, inside = split_algebra(algebra)
    if inside != UNNAMED and (field is None or inside != field.name):
        own = ring(inside)
        if field is not None and field != own:
            raise NotationError(
                f"the algebra {algebra} is over {own.name}, the field is {field.name}"
            )
        field = own
    letters: dict[str, None] = {}
    texts = []
    for text in (a, t, b):
        letters.update(dict.fromkeys(_letters(text, field)))
        texts.append(_plain(text, field))
    return Setting(field, (texts[0], texts[1], texts[2]), tuple(letters))


def _spelled(text: str, field: Ring | None) -> str:
    """Return the text of a constant in usual notation."""
    if field is None:
        return text
    node = parse(text)
    spelled = field.spelled_constants(node)
    return text if spelled == node else "".join(to_text(spelled).split()).replace("**", "^")


def _plain(text: str, field: Ring | None) -> str:
    """Return the text of a constant without blanks, in the field's own notation if the field reads it.

    The text is unchanged if its value is inexact, undecided or undefined; the prover reports that.
    """
    written = "".join(text.split())
    if field is None:
        return written
    node = parse(text)
    named = field.named_constants(node)
    if named != node:
        return to_text(named)
    if _letters(text, field):
        return written
    try:
        value = field(text)
        if not field.is_known(value):
            return written
        is_minus_one = field.characteristic != 2 and field.equal(value, field(-1))
        return "-1" if is_minus_one else field.text(value)
    except UndecidedError:
        return written
    except (CoercionError, NotInvertibleError) as error:
        if _is_undefined(text, field):
            return written
        raise NotationError(f"the structure constant {text!r}: {error}") from error


def _is_undefined(text: str, field: Ring) -> bool:
    """Return whether a constant divides by an element that is not a unit."""
    node = parse(text)
    leaves = (n for n in walk(node) if isinstance(n, Name | Call))
    try:
        fixed = {to_text(n): field(to_text(n)) for n in leaves}
        return not Evaluator(RingScalars(field), fixed=fixed).term(node)[1]
    except HFieldError:
        return False


def _letters(text: str, field: Ring | None) -> list[str]:
    node = parse(text)
    if weight(node) > MAX_CONSTANT_WEIGHT:
        raise NotationError(f"the structure constant {text[:60]!r} is too large")
    for n in walk(node):
        if isinstance(n, Index) or (isinstance(n, Call) and n.function in RESULT):
            raise NotationError(
                f"the structure constant {text!r} may use scalars only: {to_text(n)} is about quaternions"
            )
    known = generators(field) if field is not None else frozenset()
    names = [n.name for n in walk(node) if isinstance(n, Name) and n.name not in known]
    for name in names:
        if name in QUATERNIONS or name in BASIS or not re.fullmatch("[a-z]", name):
            raise NotationError(
                f"the structure constant {text!r} may use scalars only: {name!r} is none; "
                "write letters such as a, b, s, t"
            )
    return names
