"""The subject of a certificate: its statement, unknowns, algebra and field.

Everything here is derived from the keys ``statement``, ``algebra`` and ``ring``.
"""

import re
from dataclasses import dataclass, replace
from fractions import Fraction

from hfield.checker.budget import spend
from hfield.checker.language import FUNCTIONS, Call, NameTree, Tree, parse, split, substitute, walk
from hfield.checker.matrices import ENTRIES, MATRICES, without_matrices
from hfield.checker.rejection import reject, shown
from hfield.checker.scalars.ring import AnyRing
from hfield.checker.tables import Table, in_coordinates, is_table, read_table
from hfield.checker.words import has_order_words, without_words

LETTERS, SCALARS, BASIS = "pqruvw", "styxz", "eijk"
QUATERNIONS = (*LETTERS, *ENTRIES)
UNKNOWNS = (*QUATERNIONS, *MATRICES, *SCALARS)
MAX_CONSTANT_SIZE = 200


@dataclass(frozen=True)
class Setting:
    """A ring, or None for all fields at once, and the trees of the structure constants.

    ``moved`` marks a single field to which a statement about all fields is restricted. ``named`` are the
    rings that words of the statement name. ``table`` is the algebra if it is given by a table. Then the
    constants are those of H, because coordinates are scalars, and ``algebra`` is the text of the table.
    """

    field: AnyRing | None
    constants: tuple[Tree, Tree, Tree]  # a, t, b
    letters: tuple[str, ...]
    algebra: str
    moved: bool = False
    named: tuple[AnyRing, ...] = ()
    table: Table | None = None

    def with_letters(self, values: dict[str, Tree]) -> "Setting":
        """Return the algebra with all its letters replaced by terms of the field."""
        a, t, b = (substitute(tree, values) for tree in self.constants)
        return replace(self, constants=(a, t, b), letters=())


HAMILTON: tuple[Tree, Tree, Tree] = (("neg", ("num", 1)), ("num", 0), ("neg", ("num", 1)))


def read_any_setting(algebra: str, ring: AnyRing | None) -> Setting:
    """Read a quaternion algebra, or an algebra given by a table."""
    if not is_table(algebra):
        return read_setting(algebra, ring)
    table = read_table(algebra, ring)
    return Setting(ring, HAMILTON, (), f"(-1,-1|{table.ring.name})", table=table)


def read_setting(algebra: str, ring: AnyRing | None) -> Setting:
    """Read ``(a,b|F)``, ``[a,b|F)`` (t = 1) or ``[a,b,t|F)``, where F is the name of the ring."""
    name = "F" if ring is None else ring.name
    if algebra[:1] not in ("(", "[") or not algebra.endswith(f"|{name})"):
        reject(
            f"the algebra {shown(algebra)!r} is none over {shown(name)}, as (-1,-1|{shown(name)}) is"
        )
    parts = split(algebra[1 : -len(name) - 2], ",")
    if len(parts) != 2 and (len(parts) != 3 or algebra[0] == "("):
        reject(f"the algebra {shown(algebra)!r} cannot be read; expected the form (a,b|F)")
    t = parts[2] if len(parts) == 3 else "0" if algebra[0] == "(" else "1"
    trees = [parse(part) for part in (parts[0], t, parts[1])]
    letters = {name: None for tree in trees for name in _letters(tree, ring)}
    return Setting(ring, (trees[0], trees[1], trees[2]), tuple(letters), algebra)


def _letters(tree: Tree, field: AnyRing | None) -> list[str]:
    nodes = walk(tree)
    if len(nodes) > MAX_CONSTANT_SIZE:
        reject("a structure constant is too large")
    out = []
    for node in nodes:
        if node[0] == "name" and (field is None or field.constant(node) is None):
            if not re.fullmatch("[a-z]", node[1]) or node[1] in LETTERS + BASIS:
                reject(f"a structure constant may not use {shown(node[1])!r}")
            out.append(node[1])
        elif node[0] not in ("num", "name", "call", "neg", "+", "-", "*", "/", "pow"):
            reject("a structure constant is not a term of the field")
        elif node[0] == "call" and (field is None or field.constant(node) is None):
            reject(f"a structure constant uses the unknown function {shown(node[1])!r}")
    return out


@dataclass(frozen=True)
class Statement:
    """For all ``unknowns`` not in ``exists``: hypotheses ⇒ (there exist …) conclusion.

    ``unknowns`` are names with their sorts, ``q`` or ``s``; ``constants`` are trees of field elements.
    ``ordered`` is the statement with moduli and comparisons, if it has any; everything else is then about the
    real closure.
    """

    unknowns: tuple[tuple[str, str], ...]
    exists: tuple[str, ...]
    hypotheses: tuple[Tree, ...]
    conclusion: Tree
    constants: tuple[Tree, ...]
    divides: bool
    compares_unequal: bool
    ordered: Tree | None = None

    @property
    def matrix(self) -> Tree:
        """The statement without its quantifiers."""
        tree = self.conclusion
        for h in reversed(self.hypotheses):
            tree = ("=>", h, tree)
        return tree

    @property
    def given(self) -> tuple[tuple[str, str], ...]:
        """The universally quantified unknowns."""
        return tuple((name, sort) for name, sort in self.unknowns if name not in self.exists)


def read_statement(text: str, setting: Setting) -> Statement:
    """Read a statement of the language; the field and the algebra determine the meaning of names."""
    tree = parse(text)
    if setting.table is not None:
        tree = in_coordinates(tree, setting.table)
    return read_tree(tree, setting)


def read_tree(tree: Tree, setting: Setting) -> Statement:
    """Read the tree of a statement."""
    return _StatementReader(setting).read(tree)


def sort_of(tree: Tree, setting: Setting) -> tuple[str, frozenset[str], bool]:
    """Return the sort of a term, ``q`` or ``s``, the unknowns in it, and whether it may be undefined."""
    reader = _StatementReader(setting)
    return reader.term(tree), frozenset(reader.unknowns), reader.divides


class _StatementReader:
    """One pass over the tree, which finds sorts, unknowns and constants of the field."""

    def __init__(self, setting: Setting) -> None:
        self.setting = setting
        self.field, self.letters = setting.field, setting.letters
        self.structure = setting.constants
        self.unknowns: dict[str, str] = {}
        self.constants: dict[Tree, None] = {}
        self.divides = self.unequal = False

    def read(self, tree: Tree) -> Statement:
        """Return the statement."""
        tree = without_matrices(tree, self.is_constant)
        ordered = tree if has_order_words(tree) else None
        tree = without_words(tree, self.field, self.structure == HAMILTON, self.is_scalar)
        hypotheses: list[Tree] = []
        while tree[0] == "=>":
            hypotheses.append(tree[1])
            tree = tree[2]
        for h in hypotheses:
            self.truth(h)
        before, bound = set(self.unknowns), []
        while tree[0] == "exists":
            for name in tree[1]:
                free = self.unknown(name) is not None and name not in self.letters
                if not free or name in before or name in bound:
                    reject(f"'exists' cannot bind {shown(name)!r} here")
                bound.append(name)
            tree = tree[2]
        self.truth(tree)
        for name in bound:
            self.unknowns.setdefault(name, self.unknown(name) or "s")
        for constant in self.structure:
            self.term(constant)
        return Statement(
            tuple(self.unknowns.items()),
            tuple(bound),
            tuple(hypotheses),
            tree,
            tuple(self.constants),
            self.divides,
            self.unequal,
            ordered,
        )

    def is_constant(self, tree: Tree) -> bool:
        """Return whether a tree is an element of the field."""
        return self.field is not None and self.field.constant(tree) is not None

    def is_scalar(self, tree: Tree) -> bool:
        """Return whether a term is a scalar."""
        return sort_of(tree, self.setting)[0] == "s"

    def unknown(self, name: str) -> str | None:
        """Return the sort of an unknown, None for any other name."""
        if self.is_constant(("name", name)):
            return None
        if name in QUATERNIONS:
            return "q"
        return "s" if (len(name) == 1 and name in SCALARS) or name in self.letters else None

    def truth(self, tree: Tree) -> None:
        """Read a quantifier-free statement."""
        spend(5)
        if tree[0] in ("==", "!="):
            self.unequal |= tree[0] == "!="
            self.term(tree[1])
            self.term(tree[2])
        elif tree[0] in ("and", "or", "=>", "<=>", "not"):
            self.unequal |= tree[0] == "not"
            for part in tree[1:]:
                self.truth(part)
        else:
            reject("expected a statement such as p == q where there is a term or a quantifier")

    def term(self, tree: Tree) -> str:
        """Read a term and return its sort."""
        spend(5)
        if tree[0] == "num":
            self.divides |= isinstance(tree[1], Fraction)
            return "s"
        if tree[0] == "name":
            return self.name(tree)
        if tree[0] in ("neg", "pow"):
            self.divides |= tree[0] == "pow" and tree[2] < 0
            return self.term(tree[1])
        if tree[0] == "index":
            self.term(tree[1])
            return "s"
        if tree[0] in ("+", "-", "*", "/"):
            left, right = self.term(tree[1]), self.term(tree[2])
            if tree[0] == "/":
                self.divides = True
                if right == "q":
                    reject("only scalars divide")
            return "s" if left == right == "s" else "q"
        if tree[0] == "call":
            return self.call(tree)
        reject("expected a term where there is a statement")

    def name(self, tree: NameTree) -> str:
        """Read a name."""
        name = tree[1]
        if len(name) == 1 and name in BASIS:
            return "q"
        sort = self.unknown(name)
        if sort is not None:
            return self.unknowns.setdefault(name, sort)
        if self.field is None or self.field.constant(tree) is None:
            reject(f"{shown(name)!r} means nothing in the statement")
        self.constants.setdefault(tree)
        return "s"

    def call(self, tree: Call) -> str:
        """Read a function."""
        function, arguments = tree[1], tree[2]
        if function not in FUNCTIONS:
            if self.field is None or self.field.constant(tree) is None:
                reject(f"there is no function {shown(function)!r}")
            self.constants.setdefault(tree)
            return "s"
        if len(arguments) != 1 + (function == "comm"):
            reject(f"{function} does not take {len(arguments)} arguments")
        self.divides |= function == "inv"
        for x in arguments:
            self.term(x)
        return FUNCTIONS[function]
