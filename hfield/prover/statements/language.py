"""The statement language: the meaning and the sort of each name in a parsed statement.

:mod:`hfield.syntax` parses text to a tree. This module gives every node a sort (quaternion, scalar or
boolean), finds the unknowns and the constants of the field, and separates the statement into quantifiers,
hypotheses and conclusion. Grammar and meaning are defined in docs/reference/language.md.
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass
from enum import Enum
from functools import cached_property, lru_cache
from typing import TYPE_CHECKING, NoReturn

from hfield.errors import CoercionError, HFieldError, NotationError, UndecidedError
from hfield.fields.base.ring import Ring
from hfield.prover.statements.matrices import ENTRIES, expanded
from hfield.prover.statements.printing import to_text
from hfield.prover.statements.tables import FUNCTIONS, in_coordinates
from hfield.prover.statements.trees import names_in, taken_apart, tree_depth
from hfield.prover.statements.words import ARGUMENTS, need_order, order_word, without_words
from hfield.syntax import (
    Binary,
    Call,
    Compare,
    Exists,
    Index,
    Logic,
    Name,
    Negate,
    Node,
    Not,
    Number,
    Power,
    Vocabulary,
    parse,
    weight,
)
from hfield.syntax.spelling import foreign_function_hint

if TYPE_CHECKING:
    from hfield.algebra.structure_algebra import StructureAlgebra

LETTERS = frozenset("pqruvw")
QUATERNIONS = LETTERS.union(*ENTRIES.values())
SCALARS = frozenset("styxz")
BASIS = ("e", "i", "j", "k")
HAMILTON = ("-1", "0", "-1")
MAX_TREE_DEPTH = 200


class Sort(Enum):
    """The sort of a term; a scalar may stand for a quaternion, as a multiple of e."""

    QUATERNION = "quaternion"
    SCALAR = "scalar"
    BOOLEAN = "statement"

    @property
    def width(self) -> int:
        """The number of coordinates of an unknown of this sort."""
        return 1 if self is Sort.SCALAR else 4


RESULT = {
    "conj": Sort.QUATERNION,
    "inv": Sort.QUATERNION,
    "vector": Sort.QUATERNION,
    "comm": Sort.QUATERNION,
    "norm": Sort.SCALAR,
    "trace": Sort.SCALAR,
    "scalar": Sort.SCALAR,
}


@dataclass(frozen=True)
class Statement:
    """A parsed statement: for all ``unknowns``, if ``hypotheses`` then ``conclusion``.

    ``exists`` names the existential unknowns, which occur only in ``conclusion``. ``constants`` are the
    terms, by text, that are elements of the field, such as its generator. ``node`` is the whole statement as
    a tree. ``written`` is the tree before matrices, or elements of an algebra given by a table, were replaced
    by entries or coordinates. ``divides`` is true if ``/``, ``inv``, a decimal fraction or a negative power
    occurs; ``compares_unequal`` if ``!=`` or ``not`` does. ``helpers`` are unknowns of ``node`` that define
    words of ``written``. ``ordered`` is the statement with its moduli and comparisons, if it has any; then
    ``node`` is about the real closure.
    """

    text: str
    node: Node
    written: Node
    unknowns: tuple[tuple[str, Sort], ...]
    exists: tuple[str, ...]
    hypotheses: tuple[Node, ...]
    conclusion: Node
    constants: tuple[str, ...]
    divides: bool
    compares_unequal: bool
    helpers: frozenset[str] = frozenset()
    ordered: Node | None = None

    def __str__(self) -> str:
        return to_text(self.written)

    def __hash__(self) -> int:
        return hash(self.text)  # trees are long, and memories ask often

    @cached_property
    def weight(self) -> int:
        """The greatest weight of a hypothesis or of the conclusion (:func:`hfield.syntax.weight`)."""
        return max(map(weight, (*self.hypotheses, self.conclusion)))

    @property
    def assumes_of_basis(self) -> bool:
        """Whether a hypothesis contains only i, j and k, which are not unknowns."""
        named = map(names_in, self.hypotheses)
        return any(names and names <= set(BASIS) for names in named)

    @property
    def given(self) -> tuple[tuple[str, Sort], ...]:
        """The universally quantified unknowns, with their sorts."""
        return tuple((name, sort) for name, sort in self.unknowns if name not in self.exists)

    @property
    def sorts(self) -> dict[str, Sort]:
        """The unknowns with their sorts, in order of first appearance."""
        return dict(self.unknowns)


@lru_cache(maxsize=4096)
def read_statement(
    text: str,
    field: Ring | None = None,
    given: tuple[str, ...] = (),
    letters: tuple[str, ...] = (),
    constants: tuple[str, ...] = (),
    table: StructureAlgebra | None = None,
) -> Statement:
    """Read ``text``, with the hypotheses ``given`` in front of it.

    ``field`` provides the names of its generators. ``constants`` are the texts of an algebra's structure
    constants; ``letters`` are the names in them that are scalar unknowns. ``table`` is the algebra if it is
    given by a table; its elements are expanded to coordinates. Raises :class:`NotationError` with the
    position of a grammar error, an unknown name, or a wrong sort.
    """
    if field is not None and table is None:
        try:
            general = read_statement(text, None, given, letters, constants)
        except NotationError:  # perhaps it names an element of the field
            pass
        else:
            if generators(field).isdisjoint({*general.sorts, *ENTRIES}):
                need_order(general.written, field, text)
                return general  # it means the same over every field
    node = _parse(text)
    if given:
        for h in given:
            _parse(h)  # so that an error shows the hypothesis alone
        text = " => ".join(f"({part.strip()})" for part in (*given, text))
        node = _parse(text)
    return _Analysis(text, field, letters).run(node, constants, table)


@lru_cache(maxsize=4096)
def _parse(text: str) -> Node:
    node = parse(text)
    depth = tree_depth(node)
    if depth > MAX_TREE_DEPTH:
        raise NotationError(
            f"the statement nests {depth} levels deep, more than the {MAX_TREE_DEPTH} that are read; "
            "write it in parts"
        )
    return node


@lru_cache(maxsize=256)
def generators(field: Ring) -> frozenset[str]:
    """Return the names of elements of the field, which take precedence over scalar unknowns."""
    return frozenset(field.names())


@lru_cache(maxsize=4096)
def is_constant_of(field: Ring, text: str) -> bool:
    """Return whether the field reads ``text`` as one of its elements."""
    try:
        field(text)
    except UndecidedError:
        return True
    except (HFieldError, CoercionError):
        return False
    return True


def statement_words(
    field: Ring | None, letters: Collection[str] = (), table: StructureAlgebra | None = None
) -> Vocabulary:
    """Return the words of statements over a field; ``letters`` are the names in the algebra's constants."""
    taken = frozenset[str]() if field is None else generators(field)
    functions = frozenset() if field is None else frozenset(field.functions())
    own = taken.union(letters, *ENTRIES.values())
    if table is not None:
        return Vocabulary(
            LETTERS | {x for x in own if len(x) == 1},
            own.union(table.names),
            functions.union(FUNCTIONS),
        )
    return Vocabulary.of_statements(names=own, functions=functions)


class _Analysis:
    """One pass over the tree, which checks sorts and collects the parts of the statement."""

    def __init__(self, text: str, field: Ring | None, letters: tuple[str, ...]) -> None:
        self.text, self.field = text, field
        self.letters = frozenset(letters)
        self.unknowns: dict[str, Sort] = {}
        self.constants: dict[str, None] = {}
        self.divides = self.unequal = False

    def run(
        self, written: Node, constants: tuple[str, ...], table: StructureAlgebra | None
    ) -> Statement:
        taken = frozenset[str]() if self.field is None else generators(self.field)
        if table is None:
            plain = self.named(expanded(written, taken, self.text))
            hamilton = constants in ((), HAMILTON)
            node = without_words(plain, self.field, hamilton, self.text, self.is_scalar)
            helpers = names_in(node) - names_in(plain)
            ordered = None if order_word(plain) is None else plain
        else:
            node = self.named(in_coordinates(written, table, taken, self.text))
            helpers, ordered = frozenset(), None
        hypotheses, conclusion = taken_apart(node)
        exists: list[str] = []
        for h in hypotheses:
            self.need_boolean(h)
        given = set(self.unknowns)
        while isinstance(conclusion, Exists):
            for name in conclusion.names:
                self.check_bound(name, conclusion, given, exists)
                exists.append(name)
            conclusion = conclusion.body
        self.need_boolean(conclusion)
        for name in exists:
            if name not in self.unknowns:
                self.unknowns[name] = self.unknown_sort(name) or Sort.SCALAR
        for constant in constants:
            self.term(self.named(_parse(constant)))
        return Statement(
            text=self.text.strip(),
            node=node,
            written=written,
            unknowns=tuple(self.unknowns.items()),
            exists=tuple(exists),
            hypotheses=hypotheses,
            conclusion=conclusion,
            constants=tuple(self.constants),
            divides=self.divides,
            compares_unequal=self.unequal,
            helpers=helpers,
            ordered=ordered,
        )

    def named(self, node: Node) -> Node:
        """Return a tree in which each number known only to some precision is written as one call."""
        return node if self.field is None else self.field.named_constants(node)

    def is_scalar(self, node: Node) -> bool:
        """Return whether a term is a scalar."""
        return _Analysis(self.text, self.field, tuple(self.letters)).term(node) is Sort.SCALAR

    def check_bound(self, name: str, node: Node, given: set[str], exists: list[str]) -> None:
        if self.unknown_sort(name) is None:
            self.fail(f"'exists' binds an unknown, and {name!r} is none: {_UNKNOWNS}", node)
        if name in self.letters:
            self.fail(f"{name!r} is a letter of the algebra, so that it is given", node)
        if name in given or name in exists:
            self.fail(f"{name!r} is bound by 'exists' and stands for something already", node)

    def fail(self, message: str, node: Node) -> NoReturn:
        raise NotationError(message, self.text, node.position)

    def unknown_sort(self, name: str) -> Sort | None:
        if self.field is not None and name in generators(self.field):
            return None
        if name in QUATERNIONS:
            return Sort.QUATERNION
        return Sort.SCALAR if name in SCALARS or name in self.letters else None

    def need_boolean(self, node: Node) -> None:
        sort = self.sort(node)
        if sort is not Sort.BOOLEAN:
            self.fail(f"expected a statement such as p == q, found a {sort.value}", node)

    def term(self, node: Node) -> Sort:
        sort = self.sort(node)
        if sort is Sort.BOOLEAN:
            self.fail("expected a quaternion or a scalar, found a statement", node)
        return sort

    def sort(self, node: Node) -> Sort:
        match node:
            case Name():
                return self.name(node.name, node)
            case Number():
                self.divides |= not isinstance(node.value, int)
                return Sort.SCALAR
            case Negate(x):
                return self.term(x)
            case Power(x, exponent):
                self.divides |= exponent < 0
                return self.term(x)
            case Index(x, _):
                self.term(x)
                return Sort.SCALAR
            case Binary(op, x, y):
                left, right = self.term(x), self.term(y)
                if op == "/":
                    self.divides = True
                    if right is Sort.QUATERNION:
                        self.fail(
                            "only a scalar divides: write p*inv(q) or inv(q)*p, which differ", node
                        )
                both = left is Sort.SCALAR and right is Sort.SCALAR
                return Sort.SCALAR if both else Sort.QUATERNION
            case Call(function, arguments):
                return self.call(function, arguments, node)
            case Compare(op, x, y):
                self.unequal |= op == "!="
                self.term(x)
                self.term(y)
                return Sort.BOOLEAN
            case Not(x):
                self.unequal = True
                self.need_boolean(x)
                return Sort.BOOLEAN
            case Logic(_, x, y):
                self.need_boolean(x)
                self.need_boolean(y)
                return Sort.BOOLEAN
        self.fail("'exists' stands at the front, or after the last '=>' in parentheses", node)

    def name(self, name: str, node: Node) -> Sort:
        if name in BASIS:
            return Sort.QUATERNION
        sort = self.unknown_sort(name)
        if sort is not None:
            self.unknowns.setdefault(name, sort)
            return sort
        if self.field is not None and (
            name in generators(self.field) or is_constant_of(self.field, name)
        ):
            self.constants.setdefault(name)
            return Sort.SCALAR
        mend = "" if self.field is not None else "; name a field to use its generator"
        if all(letter in BASIS or self.unknown_sort(letter) for letter in name):
            mend = f"; for a product write {'*'.join(name)}"
        self.fail(f"{name!r} means nothing here: {_UNKNOWNS}{mend}", node)

    def call(self, function: str, arguments: tuple[Node, ...], node: Node) -> Sort:
        if function not in RESULT:
            text = to_text(node)
            if self.field is not None and is_constant_of(self.field, text):
                self.constants.setdefault(text)
                return Sort.SCALAR
            where = "" if self.field is None else f", nor does {self.field.name} read {text!r}"
            self.fail(
                f"there is no function {function!r}{where}{foreign_function_hint(function)}; "
                f"known functions: {', '.join(sorted((*RESULT, *ARGUMENTS)))}",
                node,
            )
        wanted = 2 if function == "comm" else 1
        if len(arguments) != wanted:
            self.fail(f"{function} takes {wanted} argument{'s'[: wanted - 1]}", node)
        self.divides |= function == "inv"
        for x in arguments:
            self.term(x)
        return RESULT[function]


_UNKNOWNS = (
    "quaternion unknowns are p q r u v w, scalar unknowns s t x y z, and the basis is e i j k"
)
