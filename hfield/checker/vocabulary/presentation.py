"""Statements about all associative algebras: words in e, i, j, k, expanded in the free ring."""

import re
from collections.abc import Mapping
from dataclasses import dataclass, replace

from hfield.checker.budget import spend, spend_products
from hfield.checker.check_result import CheckResult
from hfield.checker.glossary import ALGEBRA, COMMUTATIVE_RINGS, FIELD, PRESENTATION
from hfield.checker.language import Binary, Meaning, Tree, parse
from hfield.checker.rejection import (
    MAX_DIGITS,
    a_list,
    a_text,
    an_integer,
    an_object,
    kind_of,
    reject,
    shown,
)
from hfield.checker.scalars.finite import is_prime
from hfield.checker.scalars.ring import AnyRing

Words = dict[str, int]
ONE: Words = {"": 1}
MAX_WORDS = 5_000
MAX_WORD = 200


@dataclass(frozen=True)
class Presentation:
    """``relations`` ⇒ ``goals``, each a difference of two sides; with ``identity``, e is the identity."""

    identity: bool
    relations: tuple[Words, ...]
    goals: tuple[Words, ...]
    tree: Meaning


def read_presentation(text: str) -> Presentation | None:
    """Read ``associative(i, j, k): relations => goals``; None for other texts."""
    m = re.fullmatch(r"\s*associative\s*\(([eijk,\s]*)\)\s*:(.*)", text, re.DOTALL | re.ASCII)
    if m is None:
        return None
    letters = "".join(m[1].split())
    if letters not in ("i,j,k", "e,i,j,k"):
        reject("expected associative(i, j, k) or associative(e, i, j, k)")
    tree = parse(m[2])
    if tree[0] != "=>":
        reject("expected relations => goals")
    identity = letters == "i,j,k"
    relations, goals = ([_equation(e, identity) for e in _equations(x)] for x in tree[1:])
    return Presentation(identity, tuple(relations), tuple(goals), (letters, tree))


def _equations(tree: Tree) -> list[Binary]:
    if tree[0] == "and":
        return _equations(tree[1]) + _equations(tree[2])
    if tree[0] != "==":
        reject("relations and goals are equations")
    return [tree]


def _equation(tree: Binary, identity: bool) -> Words:
    return _add(_words(tree[1], identity), _words(tree[2], identity), -1)


def _words(tree: Tree, identity: bool) -> Words:
    if tree[0] == "num" and isinstance(tree[1], int) and (identity or not tree[1]):
        return {"": tree[1]} if tree[1] else {}
    if tree[0] == "name" and tree[1] in ("e", "i", "j", "k"):
        return {"" if tree[1] == "e" and identity else tree[1]: 1}
    if tree[0] == "neg":
        return _add({}, _words(tree[1], identity), -1)
    if tree[0] in ("+", "-"):
        x, y = (_words(t, identity) for t in tree[1:])
        return _add(x, y, 1 if tree[0] == "+" else -1)
    if tree[0] == "*":
        if tree[1][0] == "num" and isinstance(tree[1][1], int):
            return _add({}, _words(tree[2], identity), tree[1][1])
        return _times(_words(tree[1], identity), _words(tree[2], identity))
    if tree[0] == "pow" and 0 < tree[2] <= MAX_WORD:
        x = out = _words(tree[1], identity)
        for _ in range(tree[2] - 1):
            out = _times(out, x)
        return out
    reject("a relation is a polynomial in e, i, j, k with integer coefficients")


def _add(f: Words, g: Words, scale: int) -> Words:
    spend(len(f) // 8)
    out = dict(f)
    for word, c in g.items():
        _collect(out, word, scale, c)
    return out


def _collect(f: Words, word: str, c: int, d: int) -> None:
    """Add c·d·word to f."""
    spend(4)
    spend_products([c], [d])
    total = f.pop(word, 0) + c * d
    if total.bit_length() > 4 * MAX_DIGITS:
        reject("a coefficient has grown too large")
    if total:
        f[word] = total


def _times(f: Words, g: Words) -> Words:
    if len(f) * len(g) > MAX_WORDS:
        reject("a relation has too many terms")
    out: Words = {}
    for v, c in f.items():
        for w, d in g.items():
            if len(v + w) > MAX_WORD:
                reject("a word is too long")
            _collect(out, v + w, c, d)
    return out


def _a_word(value: object, identity: bool) -> str:
    word = a_text(value, "a word", MAX_WORD)
    if not set(word) <= set("ijk" if identity else "eijk"):
        reject(f"{shown(word)!r} is not a word")
    return word


def _repeated(data: object, target: tuple[Words, ...], identity: bool, what: str) -> None:
    """Check that the evidence repeats the data read from the statement."""
    listed = []
    for entry in a_list(data, what, 1):
        words: Words = {}
        for pair in a_list(entry, f"an entry of {what}"):
            c, *rest = a_list(pair, "a term", 2)
            word = _a_word(rest[0], identity)
            if len(rest) != 1 or word in words:
                reject(f"a term of {what} cannot be read")
            words[word] = an_integer(c, "a coefficient")
        listed.append(words)
    if listed != list(target):
        reject(f"the {what} of the evidence are not those of the statement")


def establish_presentation(
    target: Presentation, ring: AnyRing | None, verdict: str, evidence: object
) -> CheckResult:
    """Check the evidence for a statement about associative algebras.

    It is vacuous if the relations imply 1 = 0, because only the algebra 0 satisfies them.
    """
    if verdict == "vacuous" and kind_of(evidence) == "unsatisfiable" and target.identity:
        data = an_object(evidence, "kind proof", "the evidence")
        return _established(replace(target, goals=(ONE,)), ring, "proved", data["proof"])
    found = _established(target, ring, verdict, evidence)
    if verdict == "proved" and _is_vacuous(target, ring):
        reject("the relations never hold together: the statement is vacuous and not proved")
    return found


def _is_vacuous(target: Presentation, ring: AnyRing | None) -> bool:
    """Return whether a relation says that a unit is 0."""
    numbers = [f[""] for f in target.relations if set(f) == {""}]
    if ring is None:
        return 1 in map(abs, numbers)
    return any(n % ring.characteristic if ring.characteristic else n for n in numbers)


def _established(
    target: Presentation, ring: AnyRing | None, verdict: str, evidence: object
) -> CheckResult:
    kind = kind_of(evidence)
    own = {"presentation": "proofs", "algebra": "table goal value"}.get(kind)
    wanted = {"presentation": "proved", "algebra": "refuted"}.get(kind)
    if own is None or wanted != verdict:
        reject(f"evidence of the kind {shown(kind)!r} does not show that this is {verdict}")
    if ring is not None and not ring.is_field:
        reject("statements about associative algebras are over fields, or over all of them")
    keys = f"kind characteristic identity relations goals {own}"
    data = an_object(evidence, keys, "the evidence")
    p = an_integer(data["characteristic"], "the characteristic", 0)
    if p and not is_prime(p):
        reject("the characteristic is not a prime")
    if data["identity"] is not target.identity:
        reject("whether e is the identity is not as in the statement")
    _repeated(data["relations"], target.relations, target.identity, "relations")
    _repeated(data["goals"], target.goals, target.identity, "goals")
    if kind == "presentation":
        return _proofs(target, ring, p, data)
    if ring is not None and ring.characteristic != p:
        reject("the algebra is over another characteristic than the field has")
    _table(target, p, data)
    return CheckResult(FIELD, ALGEBRA)


def _proofs(
    target: Presentation, ring: AnyRing | None, p: int, data: Mapping[str, object]
) -> CheckResult:
    if p and (ring is None or ring.characteristic != p):
        reject("the proof is valid in one characteristic only")
    proofs = a_list(data["proofs"], "proofs")
    if len(proofs) != len(target.goals):
        reject("there are not as many proofs as goals")
    for raw, goal in zip(proofs, target.goals, strict=True):
        proof = an_object(raw, "cofactors denominator", "a proof")
        denominator = an_integer(proof["denominator"], "a denominator", 1)
        c = p or (ring.characteristic if ring is not None else 0)
        if (ring is None and denominator != 1) or (c and denominator % c == 0):
            reject("a denominator may be 0")
        total: Words = _add({}, goal, -denominator)
        for entry in a_list(proof["cofactors"], "cofactors"):
            if not isinstance(entry, list) or len(entry) != 4:
                reject("a cofactor is a list [c, left, n, right]")
            factor = an_integer(entry[0], "a coefficient")
            left, right = _a_word(entry[1], target.identity), _a_word(entry[3], target.identity)
            n = an_integer(entry[2], "the number of a relation", 0)
            if n >= len(target.relations):
                reject("there is no relation of that number")
            for word, d in target.relations[n].items():
                _collect(total, left + word + right, factor, d)
        if any(d % p if p else d for d in total.values()):
            reject("a sum of multiples of the relations is not the goal")
    return CheckResult(COMMUTATIVE_RINGS if ring is None else FIELD, PRESENTATION)


Vector = list[int]


def _table(target: Presentation, p: int, data: Mapping[str, object]) -> None:
    """Check an algebra with basis e, i, j, k in which the relations hold and a goal does not."""
    raw = an_object(data["table"], " ".join(x + y for x in "eijk" for y in "eijk"), "the table")
    table = {xy: _vector(v) for xy, v in raw.items()}

    def reduced(v: Vector) -> Vector:
        return [c % p for c in v] if p else v

    def times(v: Vector, w: Vector) -> Vector:
        out = [0] * 4
        spend(30)
        for x, c in zip("eijk", v, strict=True):
            for y, d in zip("eijk", w, strict=True):
                if c and d:
                    out = [u + c * d * z for u, z in zip(out, table[x + y], strict=True)]
        return reduced(out)

    unit = {x: [int(x == y) for y in "eijk"] for x in "eijk"}
    for x in "eijk":
        for y in "eijk":
            for z in "eijk":
                left = times(times(unit[x], unit[y]), unit[z])
                if left != times(unit[x], times(unit[y], unit[z])):
                    reject("the table is not associative")
        if target.identity and not (
            times(unit["e"], unit[x]) == unit[x] == times(unit[x], unit["e"])
        ):
            reject("e is not the identity of the table")

    def value(f: Words) -> Vector:
        total = [0] * 4
        for word, c in f.items():
            v = unit[word[0]] if word else unit["e"]
            for letter in word[1:]:
                v = times(v, unit[letter])
            spend_products([c], v)
            total = [u + c * w for u, w in zip(total, v, strict=True)]
        return reduced(total)

    if any(any(value(f)) for f in target.relations):
        reject("a relation does not hold in the table")
    goal = an_integer(data["goal"], "the number of a goal", 0)
    if goal >= len(target.goals):
        reject("there is no goal of that number")
    found = value(target.goals[goal])
    if not any(found) or found != reduced(_vector(data["value"])):
        reject("the goal does not have the value that is given, or it is 0")


def _vector(value: object) -> Vector:
    entries = [an_integer(c, "a coordinate") for c in a_list(value, "coordinates", 4)]
    if len(entries) != 4 or any(abs(c) > 10**9 for c in entries):
        reject("expected four small coordinates")
    return entries
