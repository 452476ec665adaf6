"""Evidence for statements of the language, kind by kind."""

from dataclasses import replace
from itertools import product
from typing import Any

from hfield.certificates.clauses import expand
from hfield.certificates.evaluate import Quaternion
from hfield.certificates.exhaustion import check_all, check_exists, evaluator_at
from hfield.certificates.implication import check_implication
from hfield.certificates.language import Tree, parse, substitute, walk
from hfield.certificates.over_field import Place
from hfield.certificates.rejection import (
    a_list,
    a_text,
    an_integer,
    an_object,
    reject,
    shown,
    texts,
)
from hfield.certificates.scalars.fields import read_field
from hfield.certificates.scalars.numbers import Floats
from hfield.certificates.scalars.ring import Ring
from hfield.certificates.statement import Setting, Statement, read_tree, sort_of
from hfield.certificates.work import charge

FIELD, FIELDS, RINGS = "field", "fields", "commutative rings"
MAX_TUPLES = 4**6

Shown = tuple[str, tuple[str, ...]]  # the scope, and the theorems that are cited


def establish(statement: Statement, setting: Setting, verdict: str, evidence: object) -> Shown:
    """Check the evidence for a verdict on a statement; return its scope and what it cites."""
    kind = kind_of(evidence)
    if verdict == "proved" and not statement.exists:
        return _proved(statement, setting, kind, evidence)
    if verdict == "proved":
        return _proved_exists(statement, setting, kind, evidence)
    if verdict == "refuted" and not statement.exists and kind == "witness":
        ring, values = _witness(statement, setting, evidence, statement.unknowns)
        if evaluator_at(ring, setting, statement, values).truth(statement.matrix):
            reject("the statement is true for the values of the witness")
        return FIELD, ()
    if verdict == "refuted" and statement.exists and kind in ("none exists", "place"):
        return _none_exists(statement, setting, kind, evidence)
    if verdict == "vacuous" and kind == "unsatisfiable":
        return _unsatisfiable(statement, setting, evidence)
    reject(f"evidence of the kind {shown(kind)!r} does not show that the statement is {verdict}")


def kind_of(evidence: object) -> str:
    """Return the kind of some evidence."""
    if not isinstance(evidence, dict) or not isinstance(evidence.get("kind"), str):
        reject("the evidence must be an object with a text 'kind'")
    return str(evidence["kind"])


def _proved(statement: Statement, setting: Setting, kind: str, evidence: object) -> Shown:
    ring = setting.field
    if isinstance(ring, Floats):
        reject("nothing is proved over floats")
    if kind == "exhaustion":
        data = an_object(evidence, "kind cases", "the evidence")
        check_all(statement, setting, an_integer(data["cases"], "cases", 1))
        return FIELD, ()
    if kind == "multilinear":
        return _multilinear(statement, setting, evidence)
    if ring is not None and not ring.is_field and statement.divides:
        reject(f"a statement that divides is shown over {ring.name} by all cases only")
    fields_only = statement.divides or statement.compares_unequal
    if kind == "identity":
        an_object(evidence, "kind", "the evidence")
        expansion = expand(statement, setting)
        place = Place(expansion, ring)
        if not all(map(place.is_trivial, expansion.clauses)):
            reject("the statement does not hold by expanding")
        return (FIELDS if fields_only else RINGS) if ring is None else FIELD, ()
    if kind == "implication":
        data = an_object(evidence, "kind facts items", "the evidence")
        scope, assumes = check_implication(expand(statement, setting), setting, data)
        return FIELDS if scope == RINGS and fields_only else scope, assumes
    reject(f"evidence of the kind {shown(kind)!r} does not show that the statement is proved")


def _witness(
    statement: Statement,
    setting: Setting,
    evidence: object,
    unknowns: tuple[tuple[str, str], ...],
    more: str = "",
) -> tuple[Ring, dict[str, Any]]:
    """Return the ring of a witness and its values."""
    data = an_object(evidence, f"kind values field {more}", "the evidence")
    ring = read_field(a_text(data["field"], "the field of the evidence"))
    if setting.field is None:
        if not ring.is_field or isinstance(ring, Floats):
            reject(f"{ring.name} is no field")
    elif setting.field.name != ring.name:
        reject("the field of the evidence is not that of the certificate")
    return ring, read_values(ring, data["values"], unknowns)


def read_values(
    ring: Ring, values: object, unknowns: tuple[tuple[str, str], ...]
) -> dict[str, Any]:
    """Read the coordinates of unknowns, for exactly those unknowns."""
    data = an_object(values, " ".join(name for name, _ in unknowns), "the values")
    out: dict[str, Any] = {}
    for name, sort in unknowns:
        found = [ring.read(text) for text in texts(data[name], f"the values of {name}", 1)]
        if len(found) != (1 if sort == "s" else 4):
            reject(f"{name} has {len(found)} coordinates")
        out[name] = found[0] if sort == "s" else Quaternion(found)
    return out


def _proved_exists(statement: Statement, setting: Setting, kind: str, evidence: object) -> Shown:
    if isinstance(setting.field, Floats):
        reject("nothing is proved over floats")
    if kind == "witness" and not statement.given and setting.field is not None:
        ring, values = _witness(statement, setting, evidence, statement.unknowns)
        if not evaluator_at(ring, setting, statement, values).truth(statement.matrix):
            reject("the statement is false for the values of the witness")
        return FIELD, ()
    if kind == "exhaustion":
        data = an_object(evidence, "kind cases", "the evidence")
        check_exists(statement, setting, an_integer(data["cases"], "cases", 1))
        return FIELD, ()
    if kind == "terms":
        return _terms(statement, setting, evidence)
    reject(f"evidence of the kind {shown(kind)!r} does not show that something exists")


def _terms(statement: Statement, setting: Setting, evidence: object) -> Shown:
    data = an_object(evidence, "kind terms proof", "the evidence")
    terms = an_object(data["terms"], " ".join(statement.exists), "the terms")
    given, sorts = {name for name, _ in statement.given}, dict(statement.unknowns)
    chosen: dict[str, Tree] = {}
    for name in statement.exists:
        tree = parse(a_text(terms[name], f"the term for {name}"))
        sort, unknowns = sort_of(tree, setting)
        if not unknowns <= given or (sort == "q" and sorts[name] == "s"):
            reject(f"the term for {name} does not fit")
        # What is not defined does not exist; but it makes every comparison false.
        if _may_be_undefined(tree) and not _is_monotone(statement.conclusion):
            reject(f"the term for {name} may be undefined")
        chosen[name] = tree
    instance = read_tree(substitute(statement.matrix, chosen), setting)
    scope, assumes = establish(instance, setting, "proved", data["proof"])
    return (FIELDS if setting.field is None else scope), assumes


def _may_be_undefined(tree: Tree) -> bool:
    return any(
        node[0] == "/"
        or (node[0] == "pow" and node[2] < 0)
        or (node[0] == "call" and node[1] == "inv")
        or (node[0] == "num" and not isinstance(node[1], int))
        for node in walk(tree)
    )


def _is_monotone(tree: Tree) -> bool:
    """Tell whether a statement is made of comparisons by "and" and "or" alone."""
    return tree[0] in ("==", "!=") or (
        tree[0] in ("and", "or") and _is_monotone(tree[1]) and _is_monotone(tree[2])
    )


def _none_exists(statement: Statement, setting: Setting, kind: str, evidence: object) -> Shown:
    if setting.field is None:
        if not isinstance(evidence, dict) or "field" not in evidence:
            reject("the evidence must name the field in which nothing exists")
        name = a_text(evidence["field"], "the field of the evidence")
        ring = read_field(name)
        if not ring.is_field:
            reject(f"{ring.name} is no field")
        here = replace(setting, field=ring)
        evidence = {key: value for key, value in evidence.items() if key != "field"}
        return _none_exists(statement, here, kind, evidence)
    matrix = statement.matrix
    if kind == "place":
        data = an_object(evidence, "kind values proof", "the evidence")
        read_values(setting.field, data["values"], statement.given)
        values = {name: _tree_of(data["values"][name]) for name, _ in statement.given}
        matrix, evidence = substitute(matrix, values), data["proof"]
    elif statement.given:
        reject("nothing is said about the unknowns that are given")
    data = an_object(evidence, "kind proof", "the evidence")
    if data["kind"] != "none exists":
        reject("a place refutes by evidence of the kind 'none exists'")
    never = read_tree(("not", matrix), setting)
    _, assumes = establish(never, setting, "proved", data["proof"])
    return FIELD, assumes


def _tree_of(coordinates: list[str]) -> Tree:
    """Return the tree of c₀ + c₁·i + c₂·j + c₃·k, or of a scalar."""
    if len(coordinates) == 1:
        return parse(coordinates[0])
    parts = [("*", parse(c), ("name", u)) for c, u in zip(coordinates, "eijk", strict=True)]
    return ("+", ("+", parts[0], parts[1]), ("+", parts[2], parts[3]))


def _unsatisfiable(statement: Statement, setting: Setting, evidence: object) -> Shown:
    data = an_object(evidence, "kind proof", "the evidence")
    if not statement.hypotheses:
        reject("there are no hypotheses")
    tree = statement.hypotheses[0]
    for h in statement.hypotheses[1:]:
        tree = ("and", tree, h)
    never = read_tree(("not", tree), setting)
    return establish(never, setting, "proved", data["proof"])


def _multilinear(statement: Statement, setting: Setting, evidence: object) -> Shown:
    data = an_object(evidence, "kind unknowns tuples", "the evidence")
    tree, names = statement.conclusion, [name for name, _ in statement.unknowns]
    if tree[0] != "==" or statement.hypotheses or any(s != "q" for _, s in statement.unknowns):
        reject("the statement is no equation between multilinear maps")
    if texts(data["unknowns"], "unknowns") != names or setting.letters or not names:
        reject("the unknowns are not those of the statement")
    once = {(1,) * len(names)}
    if not all(_degrees(side, names) <= once for side in tree[1:]):
        reject("a side of the equation is not linear in each unknown")
    ring = setting.field or read_field("ZZ")
    found: dict[str, Any] = {}
    for entry in a_list(data["tuples"], "tuples", 1):
        word, value = a_list(entry, "a tuple", 2)[:2] if isinstance(entry, list) else (None, None)
        if not isinstance(word, str) or word in found or len(entry) != 2:
            reject("an entry of 'tuples' is not a word with four coordinates, or comes twice")
        found[word] = [
            ring.number(an_integer(c, "a coordinate")) for c in a_list(value, "coordinates", 4)
        ]
    if 4 ** len(names) > MAX_TUPLES or len(found) != 4 ** len(names):
        reject("the list of tuples of basis vectors is not complete")
    for word in map("".join, product("eijk", repeat=len(names))):
        charge(1_000)
        if word not in found:
            reject("the list of tuples of basis vectors is not complete")
        values = {
            name: Quaternion([ring.one if u == letter else ring.zero for u in "eijk"])
            for name, letter in zip(names, word, strict=True)
        }
        evaluator = evaluator_at(ring, setting, statement, values)
        for side in tree[1:]:
            x, _ = evaluator.term(side)
            pairs = zip(evaluator.quaternion(x), found[word], strict=False)
            if len(found[word]) != 4 or not all(ring.equal(u, v) for u, v in pairs):
                reject(f"the sides at {word} are not what the list says")
    return (RINGS if setting.field is None else FIELD), ()


def _degrees(tree: Tree, names: list[str]) -> set[tuple[int, ...]]:
    """Return in which degrees in each unknown the terms are; rejects what is not multilinear."""
    kind = tree[0]
    if kind == "num" and isinstance(tree[1], int):
        return {(0,) * len(names)} if tree[1] else set()
    if kind == "name":
        return {tuple(int(tree[1] == name) for name in names)}
    if kind in ("neg", "index"):
        return _degrees(tree[1], names)
    if kind == "call" and tree[1] in ("conj", "trace", "scalar", "vector"):
        return _degrees(tree[2][0], names)
    if kind in ("+", "-"):
        return _degrees(tree[1], names) | _degrees(tree[2], names)
    if kind == "*" or (kind == "call" and tree[1] == "comm"):
        left, right = (_degrees(x, names) for x in (tree[1:] if kind == "*" else tree[2]))
        if len(left) * len(right) > MAX_TUPLES:
            reject("a side of the equation has too many degrees")
        return {tuple(a + b for a, b in zip(u, v, strict=True)) for u in left for v in right}
    reject("a side of the equation is not linear in each unknown")
