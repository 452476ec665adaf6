"""Prove consequences of relations between letters in every associative algebra.

With ``identity`` the algebra has an identity element ``e``. Without it, ``e`` is a letter like the others, as
in the printed Theorem 1 of the thesis, and the statement may fail.

What refutes is a small associative algebra in which the product of two basis vectors is ± a basis vector or
0. It is found by backtracking over the products; associativity and the relations are checked as soon as the
products that they need are there.
"""

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import product
from math import lcm

from hfield.checker.glossary import ALGEBRA, PRESENTATION
from hfield.errors import NotationError, shorten
from hfield.evidence import Evidence, Kind
from hfield.fields.base.ring import Ring
from hfield.fields.names import ring
from hfield.prover.clock import Clock
from hfield.prover.decision import (
    COMMUTATIVE_RINGS,
    FIELD,
    PROVED,
    REFUTED,
    VACUOUS,
    Decision,
    Scope,
    undecided,
)
from hfield.prover.polynomials.free_algebra import Cofactors, Rewriting, multiply_out
from hfield.prover.polynomials.vanishing import prime_factors
from hfield.prover.problem import MEMORY
from hfield.prover.statements.printing import to_text
from hfield.prover.statements.trees import conjuncts
from hfield.prover.steps import say
from hfield.syntax import Binary, Compare, Name, Negate, Node, Number, Power, parse, plain, weight

Words = dict[str, int]
ONE: Words = {"": 1}
Entry = tuple[int, int]  # sign (0 for the product 0), index of the basis vector
Table = dict[tuple[int, int], Entry]
Vector = list[int]

MAX_WEIGHT = 60
MAX_TERMS = 2_000


@dataclass(frozen=True)
class _Target:
    """What is to be shown: with or without an identity, that the relations imply the goals."""

    identity: bool
    relations: list[Words]
    goals: list[Words]

    def data(self) -> dict[str, object]:
        """Return this as evidence repeats it, words in lists after their coefficients."""
        return {
            "identity": self.identity,
            "relations": [_listed(f) for f in self.relations],
            "goals": [_listed(f) for f in self.goals],
        }


def decide_presentation(
    relations: Sequence[str | Mapping[str, int]],
    goals: Sequence[str | Mapping[str, int]],
    identity: bool = True,
    field: Ring | str | None = None,
    timeout: float = 30.0,
) -> Decision:
    """Decide whether the relations imply all the goals in every associative algebra.

    Relations and goals are equations or polynomials in the letters e, i, j, k: a text such as ``i*j*k ==
    -e``, or a map from words to coefficients (the empty word is the identity). ``field`` restricts the
    algebras to those over fields of its characteristic. A proof consists of cofactors; a refutation is an
    algebra with basis e, i, j, k, given by its multiplication table. If the relations imply 1 = 0, the result
    is vacuous.
    """
    clock = Clock.of(timeout)
    p = 0 if field is None else ring(field).characteristic
    read_relations = [_read(r, identity) for r in relations]
    read_goals = [_read(g, identity) for g in goals]
    letters = "ijk" if identity else "eijk"
    target = _Target(identity, read_relations, read_goals)
    characteristics_tried = [0, 2] if field is None else [p]
    for q in dict.fromkeys((0, p)):
        proof = _prove(read_relations, read_goals, letters, q, clock)
        if proof is None:
            continue
        divided_by = lcm(*(d for _, d in proof))
        if divided_by == 1 or (field is not None and q == p):
            never = _prove(read_relations, [ONE], letters, q, clock) if identity else None
            if never and (never[0][1] == 1 or (field is not None and q == p)):
                return _vacuous(never, target, q)
            return _proved(proof, target, q)
        if field is None:
            characteristics_tried += prime_factors(divided_by) or []
    for q in dict.fromkeys(characteristics_tried):
        found = find_table("eijk", "e" if identity else None, read_relations, read_goals, q, clock)
        if found is not None:
            return _refuted(found, target, q, field is None)
    return undecided("rewriting", "tables with entries 0, ±1", method=PRESENTATION)


def presentation_text(relations: Sequence[str], goals: Sequence[str], identity: bool = True) -> str:
    """Write the decided statement in the notation of certificates."""
    letters = "i, j, k" if identity else "e, i, j, k"
    return f"associative({letters}): {' and '.join(relations)} => {' and '.join(goals)}"


def read_relations(relations: str | Iterable[str]) -> tuple[str, ...]:
    """Return equations with two sides each; ``x == y == z`` means ``x == z`` and ``y == z``.

    A text may contain several joined by ``and``, and there may be several texts. Raises
    :class:`NotationError`.
    """
    texts = [relations] if isinstance(relations, str) else relations
    found: list[str] = []
    for part in (part for text in texts for part in re.split(r"\band\b", plain(text))):
        sides = [side.strip() for side in part.split("==")]
        if len(sides) != 2 or not all(sides):
            raise NotationError(
                f"{shorten(part.strip())!r} is not a relation: expected an equation such as i*i == -1"
            )
        found.append(" == ".join(sides))
    return tuple(found)


def read_goals(statement: str) -> tuple[str, ...]:
    """Return the equations joined by ``and`` in a statement. Raises :class:`NotationError`."""
    goals = conjuncts(parse(statement))
    for goal in goals:
        if not (isinstance(goal, Compare) and goal.op == "=="):
            raise NotationError(
                "the conclusion from relations must be equations, joined by 'and'",
                statement,
                goal.position,
            )
    return tuple(map(to_text, goals))


Proof = list[tuple[Cofactors, int]]  # for each goal, with the divisor


def _prove(
    relations: list[Words], goals: list[Words], letters: str, p: int, clock: Clock
) -> Proof | None:
    """Prove, with a cache shared by all fields; proofs that ran out of time are retried."""
    key = (letters, p, *(tuple(f.items()) for f in (*relations, *goals)), len(goals))
    return MEMORY.recall(
        "presentations",
        key,
        lambda: _attempt(relations, goals, letters, p, clock),
        lambda: not clock.is_late,
    )


def _attempt(
    relations: list[Words], goals: list[Words], letters: str, p: int, clock: Clock
) -> Proof | None:
    system = Rewriting(relations, p, letters, clock)
    found = [system.member(g) for g in goals]
    if any(f is None for f in found):
        system.run()
        found = [system.member(g) for g in goals]
    out = []
    for goal, cofactors in zip(goals, found, strict=True):
        if cofactors is None:
            return None
        scale = lcm(*(Fraction(c).denominator for c in cofactors.values()))
        whole: Cofactors = {place: int(c * scale) for place, c in cofactors.items()}
        difference = multiply_out(whole, relations)
        for word, c in goal.items():
            difference[word] = difference.get(word, 0) - c * scale
        if any(c % p if p else c for c in difference.values()):
            return None
        out.append((whole, scale))
    return out


def _proved(proof: Proof, target: _Target, p: int) -> Decision:
    steps = []
    entries = []
    for (cofactors, scale), goal in zip(proof, target.goals, strict=True):
        terms = " + ".join(
            f"{'' if c == 1 else f'({c})·'}{left}({_shown(target.relations[n])}){right}"
            for (left, n, right), c in cofactors.items()
        )
        steps.append(f"{'' if scale == 1 else scale}({_shown(goal)}) = {terms or 0}")
        entries.append(
            {
                "cofactors": [[c, left, n, right] for (left, n, right), c in cofactors.items()],
                "denominator": scale,
            }
        )
    evidence = Evidence(Kind.PRESENTATION, characteristic=p, **target.data(), proofs=entries)
    integral = all(scale == 1 for _, scale in proof)
    scope = Scope.characteristics([p]) if p else COMMUTATIVE_RINGS if integral else FIELD
    return Decision(PROVED, PRESENTATION, None, tuple(steps), scope, evidence=evidence)


def _vacuous(proof: Proof, target: _Target, p: int) -> Decision:
    shown = _proved(proof, replace(target, goals=[ONE]), p)
    steps = (*shown.steps, say("trivial-only"))
    evidence = Evidence(Kind.UNSATISFIABLE, proof=shown.evidence)
    return replace(shown, verdict=VACUOUS, steps=steps, evidence=evidence)


def _refuted(
    found: tuple[Table, int, list[int]], target: _Target, p: int, everywhere: bool
) -> Decision:
    table, goal, value = found
    names = "eijk"
    products = {
        names[x] + names[y]: [sign if n == at else 0 for n in range(4)]
        for (x, y), (sign, at) in sorted(table.items())
    }
    shown = ", ".join(
        f"{place} = {_shown({names[n]: c for n, c in enumerate(v) if c})}"
        for place, v in products.items()
    )
    vector = _shown({names[n]: c for n, c in enumerate(value) if c})
    failing = {"x": _shown(target.goals[goal]), "y": vector, "p": p}
    last = say("is-there-in" if p else "is-there", **failing)
    steps = (say("table", table=shown), say("relations-hold"), last)
    shown_by: dict[str, object] = {"table": products, "goal": goal, "value": value}
    evidence = Evidence(Kind.ALGEBRA, characteristic=p, **target.data(), **shown_by)
    witness = {place: [str(c) for c in v] for place, v in products.items()}
    if everywhere:
        witness["F"] = [f"GF({p})" if p else "QQ"]
    return Decision(REFUTED, ALGEBRA, witness, steps, evidence=evidence)


def _listed(f: Words) -> list[list[int | str]]:
    return [[c, word] for word, c in f.items()]


def _shown(f: Words) -> str:
    out = ""
    for word, c in f.items():
        body = word or "1" if abs(c) == 1 else f"{abs(c)}{word}"
        sign = "−" if c < 0 else "+"
        out += f" {sign} {body}" if out else (f"−{body}" if c < 0 else body)
    return out or "0"


def _read(source: str | Mapping[str, int], identity: bool) -> Words:
    if not isinstance(source, str):
        for word in source:
            if set(word) - set("eijk") or (not word and not identity):
                raise NotationError(f"{word!r} is not a word in the letters {'eijk'[identity:]}")
        words = {w.replace("e", "") if identity else w: int(c) for w, c in source.items()}
        return {w: c for w, c in words.items() if c}
    node = parse(source)
    if weight(node) > MAX_WEIGHT:
        raise NotationError(f"{source[:60]!r} is too large for a relation")
    reader = _WordReader(source, identity)
    if isinstance(node, Compare) and node.op == "==":
        return _sum(reader.read(node.left), reader.read(node.right), -1)
    return reader.read(node)


class _WordReader:
    """Reads a term as a polynomial in noncommuting letters."""

    def __init__(self, text: str, identity: bool) -> None:
        self.text, self.identity = text, identity

    def read(self, node: Node) -> Words:
        """Return the polynomial."""
        match node:
            case Number(value) if isinstance(value, int) and (self.identity or value == 0):
                return {"": value} if value else {}
            case Name(name) if name in ("e", "i", "j", "k"):
                return {"" if name == "e" and self.identity else name: 1}
            case Negate(x):
                return _sum({}, self.read(x), -1)
            case Binary("*", Number(value), x) if isinstance(value, int):
                return _sum({}, self.read(x), value)
            case Binary("+" | "-" as op, x, y):
                return _sum(self.read(x), self.read(y), 1 if op == "+" else -1)
            case Binary("*", x, y):
                return self.times(self.read(x), self.read(y), node)
            case Power(x, n) if n > 0:
                out = base = self.read(x)
                for _ in range(n - 1):
                    out = self.times(out, base, node)
                return out
        letters = "i, j, k and the identity e" if self.identity else "e, i, j, k (no identity)"
        raise NotationError(
            f"a relation is a polynomial in {letters} with integer coefficients",
            self.text,
            node.position,
        )

    def times(self, f: Words, g: Words, node: Node) -> Words:
        """Return the product. Raises NotationError if it has too many terms."""
        if len(f) * len(g) > MAX_TERMS:
            raise NotationError("the relation has too many terms", self.text, node.position)
        out: Words = {}
        for v, c in f.items():
            for w, d in g.items():
                out[v + w] = out.get(v + w, 0) + c * d
        return {w: c for w, c in out.items() if c}


def _sum(f: Words, g: Words, factor: int) -> Words:
    out = dict(f)
    for word, c in g.items():
        out[word] = out.get(word, 0) + factor * c
    return {word: c for word, c in out.items() if c}


def evaluate(f: Mapping[str, int], letters: str, table: Table, unit: int | None) -> Vector | None:
    """Return the value of a polynomial at the basis vectors, or None if a product is missing.

    The empty word is the basis vector ``unit``, which is then the identity.
    """
    out = [0] * len(letters)
    for word, c in f.items():
        sign, at = (1, letters.index(word[0])) if word else (1, unit or 0)
        for letter in word[1:]:
            entry = table.get((at, letters.index(letter)))
            if entry is None:
                return None
            sign, at = sign * entry[0], entry[1]
            if not sign:
                break
        out[at] += c * sign
    return out


def is_associative(table: Table, size: int) -> bool:
    """Return whether (xy)z = x(yz) wherever the required products are known."""
    for x, y, z in product(range(size), repeat=3):
        xy, yz = table.get((x, y)), table.get((y, z))
        if xy is None or yz is None:
            continue
        left = (0, 0) if not xy[0] else table.get((xy[1], z))
        right = (0, 0) if not yz[0] else table.get((x, yz[1]))
        if left is None or right is None:
            continue
        a = (xy[0] * left[0], left[1])
        b = (yz[0] * right[0], right[1])
        if a != b and (a[0] or b[0]):
            return False
    return True


def find_table(
    letters: str,
    unit: str | None,
    relations: Sequence[Mapping[str, int]],
    goals: Sequence[Mapping[str, int]],
    p: int,
    clock: Clock,
) -> tuple[Table, int, Vector] | None:
    """Return a table that satisfies the relations but not a goal, with that goal and its value.

    Coefficients are modulo p if p is prime, and in ℤ for p = 0; for p = 2 there are no signs. ``unit`` is the
    letter of the identity, if there must be one. Tables graded by the Klein four-group, like that of H, come
    first, then all others.
    """
    size = len(letters)
    identity = None if unit is None else letters.index(unit)
    signs = (1, 0) if p == 2 else (1, -1, 0)
    entries = [(s, n) for s in signs for n in range(size if s else 1)]
    table: Table = {}
    if identity is not None:
        for n in range(size):
            table[identity, n] = table[n, identity] = (1, n)
    places = [(x, y) for x in range(size) for y in range(size) if (x, y) not in table]
    places.sort(key=lambda place: (place[0] != place[1], identity is None and 0 in place))

    def is_zero(v: Vector) -> bool:
        return not any(c % p if p else c for c in v)

    def fits() -> bool:
        values = (evaluate(f, letters, table, identity) for f in relations)
        return is_associative(table, size) and all(v is None or is_zero(v) for v in values)

    def search(n: int, graded: bool) -> tuple[Table, int, Vector] | None:
        if clock.is_late:
            return None
        if n == len(places):
            for m, goal in enumerate(goals):
                value = evaluate(goal, letters, table, identity)
                if value is not None and not is_zero(value):
                    return dict(table), m, value
            return None
        x, y = places[n]
        for entry in [(s, x ^ y) for s in signs if s] if graded else entries:
            table[places[n]] = entry
            if fits():
                found = search(n + 1, graded)
                if found is not None:
                    return found
        del table[places[n]]
        return None

    return (search(0, True) or search(0, False)) if fits() else None
