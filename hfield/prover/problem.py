"""A problem: a statement, its setting, a deadline, and a cache shared with earlier problems."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterator
from dataclasses import dataclass, replace
from dataclasses import field as a_field
from functools import wraps
from typing import Any, Concatenate, ParamSpec, TypeVar, cast

from hfield.fields.base.ring import Ring
from hfield.prover.clock import UNTIMED, Clock
from hfield.prover.statements.language import RESULT, Statement, generators
from hfield.prover.statements.printing import to_text
from hfield.prover.statements.setting import Setting
from hfield.prover.statements.trees import divides_in, implication, taken_apart
from hfield.syntax import Call, Name, Node, children

MAX_KEPT = 8_192  # answers to a question of one kind
_NOTHING = object()
P = ParamSpec("P")
T = TypeVar("T")


class Memory:
    """A cache of functions of problems, shared by fields and statements."""

    def __init__(self) -> None:
        self._kept: dict[str, dict[Hashable, Any]] = {}  # by the kind what its functions return

    def recall(
        self, kind: str, key: Hashable, make: Callable[[], T], lasting: Callable[[], bool]
    ) -> T:
        """Return the cached value of a key, or compute it and cache it if it is ``lasting``."""
        kept = self._kept.setdefault(kind, {})
        found: T = kept.get(key, _NOTHING)
        if found is _NOTHING:
            found = make()
            if lasting():
                if len(kept) >= MAX_KEPT:
                    kept.clear()
                kept[key] = found
        return found

    def cache_clear(self) -> None:
        """Clear the cache, under the same name as in functools."""
        self._kept.clear()


MEMORY = Memory()  # shared by all problems of the process without a budget of their own


@dataclass(frozen=True)
class Problem:
    """A ``statement`` to be decided in a ``setting`` before the ``clock`` runs out."""

    statement: Statement
    setting: Setting
    clock: Clock = UNTIMED
    memory: Memory = a_field(default=MEMORY, compare=False, repr=False)

    @property
    def field(self) -> Ring | None:
        """The ring, nearly always a field; None for all fields at once."""
        return self.setting.field

    @property
    def ring(self) -> Ring:
        """The ring of a problem about one ring."""
        assert self.setting.field is not None
        return self.setting.field

    @property
    def letters(self) -> frozenset[str]:
        """The unknowns that are structure constants; for these 0 is tried last."""
        return frozenset(self.setting.letters).intersection(self.statement.sorts)

    # --- time ------------------------------------------------------------------------------------

    @property
    def is_late(self) -> bool:
        """Whether the time limit was reached."""
        return self.clock.is_late

    def within(self, seconds: float) -> Problem:
        """Return the problem with at most ``seconds`` of the remaining time."""
        return replace(self, clock=self.clock.within(seconds))

    def share(self, part: float, least: float = 0.0) -> Problem:
        """Return the problem with a fraction of the remaining time, or ``least`` seconds."""
        return replace(self, clock=self.clock.share(part, least))

    # --- other problems --------------------------------------------------------------------------

    def over(self, ring: Ring) -> Problem:
        """Return the problem over another ring."""
        return replace(self, setting=replace(self.setting, field=ring))

    def with_statement(self, statement: Statement) -> Problem:
        """Return another problem with the same setting and deadline."""
        return replace(self, statement=statement)

    def for_formula(self, node: Node, names: tuple[str, ...] | None = None) -> Problem:
        """Return the problem ``node`` for all values of the unknowns, or of the unknowns ``names``.

        Constants of the field that were substituted for unknowns count as constants of the statement.
        """
        old = self.statement
        unknowns = old.unknowns
        if names is not None:
            unknowns = tuple((name, sort) for name, sort in unknowns if name in names)
        hypotheses, conclusion = taken_apart(node)
        made = replace(
            old,
            text=to_text(node),
            node=node,
            written=node,
            unknowns=unknowns,
            exists=(),
            hypotheses=hypotheses,
            conclusion=conclusion,
            constants=tuple(dict.fromkeys((*old.constants, *constants_in(node, self.field)))),
            divides=old.divides or divides_in(node),
        )
        return self.with_statement(made)

    def without_constants(self, node: Node, names: tuple[str, ...] | None = None) -> Problem:
        """Return the same problem without constants of the field that occur neither in it nor in
        the algebra.
        """
        made, trees = self.for_formula(node, names), (node, *self.setting.trees)
        used = {text for tree in trees for text in constants_in(tree, self.field)}
        own = tuple(text for text in made.statement.constants if text in used)
        return made.with_statement(replace(made.statement, constants=own))

    @property
    def matrix(self) -> Node:
        """The quantifier-free part: hypotheses ⇒ conclusion."""
        return implication(self.statement.hypotheses, self.statement.conclusion)


def constants_in(node: Node, ring: Ring | None) -> Iterator[str]:
    """Yield the texts of the ring's constants in a tree."""
    if ring is None:
        return
    if isinstance(node, Name):
        if node.name in generators(ring):
            yield node.name
    elif isinstance(node, Call) and node.function not in RESULT:
        yield to_text(node)
    else:
        for child in children(node):
            yield from constants_in(child, ring)


def remembered(
    function: Callable[Concatenate[Problem, P], T],
) -> Callable[Concatenate[Problem, P], T]:
    """Cache the results of a function of a problem, unless it ran out of time.

    The statement and the structure constants identify the problem. If the function depends on more, such as
    the ring, that must be among its arguments, which are hashable.
    """

    @wraps(function)
    def recalling(problem: Problem, *args: P.args, **kwargs: P.kwargs) -> T:
        key = (problem.statement, problem.setting.constants, args, tuple(kwargs.items()))
        return problem.memory.recall(
            f"{function.__module__}.{function.__qualname__}",
            key,
            lambda: function(problem, *args, **kwargs),
            lambda: not problem.is_late,
        )

    return cast(Callable[Concatenate[Problem, P], T], recalling)
