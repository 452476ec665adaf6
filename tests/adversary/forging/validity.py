"""Whether evidence that differs from the original is valid all the same, by other means than the checker's.

Witnesses are evaluated in the package's own rings, cofactors multiplied out by flint, words by the
prover's rewriting; for the rest the prover decides again. Nothing of hfield.checker is used.
"""

import re
from collections.abc import Callable
from itertools import product
from typing import Any

from flint import fmpz_mat

from hfield.core.product import Constants, multiply, norm
from hfield.errors import HFieldError
from hfield.fields.names import ring
from hfield.ledger.linear_algebra import centre_equations
from hfield.prover.evaluation.evaluator import Evaluator
from hfield.prover.evaluation.scalars import RingScalars
from hfield.prover.polynomials.free_algebra import multiply_out
from hfield.prover.prove import prove
from hfield.prover.statements.language import read_statement
from hfield.prover.statements.setting import read_setting
from tests.adversary.forging.validity_of_items import implication
from tests.adversary.grammar import NotRead
from tests.adversary.ring_names import name_of

Certificate = dict[str, Any]


def same_target(mutant: Certificate, original: Certificate) -> bool:
    """Tell whether two certificates are about the same."""
    return mutant["statement"] == original["statement"] and _where(mutant) == _where(original)


def why_valid(mutant: Certificate, original: Certificate) -> str:
    """Return why a mutant with the target of the original is valid, '' if no reason is found."""
    try:
        return _evidence(mutant["evidence"], original["evidence"], mutant)
    except (HFieldError, NotRead, KeyError, ValueError, IndexError, TypeError):
        return ""


def _where(data: Certificate) -> Any:
    """Return the field and the structure constants, by their values where no letters are in them."""
    field = data["field"]
    if field is not None and name_of(data["ring"]) != field:
        raise NotRead(f"the data are not those of {field}")
    setting = read_setting(field, data["algebra"])
    if setting.letters:
        return setting, data["verdict"]
    base = setting.field or ring("QQ")
    constants = tuple(base.text(base(text)) for text in setting.constants)
    return field, constants, data["verdict"]


def _evidence(new: Any, old: Any, data: Certificate) -> str:
    if new == old:
        return "same evidence"
    kind = new.get("kind")
    empty = {"kind": "implication", "facts": [], "items": []}
    if kind == "identity":  # that is an implication without items
        return _evidence(empty, old, data)
    if old.get("kind") == "identity":
        return _evidence(new, empty, data)
    if kind != old.get("kind"):
        return ""
    if _spelt(new, data) == _spelt(old, data):
        return "other spelling"
    nested = [key for key in ("proof", "evidence") if isinstance(new.get(key), dict)]
    if nested and all(new[key] == old[key] for key in new if key not in nested):
        inside = {**data, **_inside(kind, new, data)}
        return _evidence(new[nested[0]], old[nested[0]], inside)
    if kind == "lemmas" and len(new["proofs"]) == len(old["proofs"]):
        proofs = zip(new["proofs"], old["proofs"], strict=True)
        reasons = [_evidence(x, y, data) for x, y in proofs]
        return "valid lemmas" if all(reasons) else ""
    if kind in ("parts", "both"):
        found = []
        for n, (x, y) in enumerate(zip(_parts(new), _parts(old), strict=True)):
            part = {**data, "statement": _texts(data)[n], "verdict": x["verdict"]}
            found.append(
                x["verdict"] == y["verdict"] and _evidence(x["evidence"], y["evidence"], part)
            )
        return str(found[0]) if all(found) else ""
    checks: dict[Any, Callable[[Any, Any, Certificate], bool]] = {
        "witness": lambda a, b, d: _witness(a, d),
        "implication": implication,
        "presentation": _presentation,
        "minor": lambda a, b, d: _minor(a, d),
        "no root": lambda a, b, d: ring(d["field"]).sqrt(_norm(a, d)) is None,
        "zero norm": lambda a, b, d: _zero_norm(a, d),
        "squares": lambda a, b, d: _squares(a, d),
        "place": lambda a, b, d: _place(a, d),
        "terms": lambda a, b, d: _terms(a, d),
        "left out": lambda a, b, d: _left_out(a, d),
        "all choices": _choices,
        "algebra": lambda a, b, d: _reduced(a) == _reduced(b),
    }
    return f"valid {kind}" if kind in checks and checks[kind](new, old, data) else ""


def _inside(kind: Any, evidence: Any, data: Certificate) -> Certificate:
    """Return what evidence inside of evidence is about."""
    if kind in ("over", "none exists") and "ring" in evidence:
        over = data["statement"].startswith("not-everywhere")
        inner = {"statement": _texts(data)[0]} if over else {}
        field = name_of(evidence["ring"])
        return {"field": field, "algebra": f"(-1,-1|{field})", "verdict": "refuted", **inner}
    places = {"part": evidence.get("part", 0), "hypothesis": 0, "conclusion": 1}
    if kind not in places:
        return {}
    verdict = "refuted" if kind == "hypothesis" else data["verdict"]
    return {"statement": _texts(data)[places[kind]], "verdict": verdict}


def _texts(data: Certificate) -> list[str]:
    """Return the parts of ``word{P; Q}``."""
    parts, depth = [""], 0
    for char in data["statement"].partition("{")[2].rpartition("}")[0]:
        depth += (char == "{") - (char == "}")
        if char == ";" and not depth:
            parts.append("")
        else:
            parts[-1] += char
    return [part.strip() for part in parts]


def _parts(evidence: Any) -> list[Any]:
    return evidence["parts"] if "parts" in evidence else [evidence["left"], evidence["right"]]


def _spelt(value: Any, data: Certificate) -> Any:
    """Replace texts by the elements of the field, and numbers by themselves, as far as they are read."""
    if isinstance(value, dict):
        return {
            k: _spelt(v, {**data, "field": name_of(value["ring"])} if "ring" in value else data)
            for k, v in value.items()
        }
    if isinstance(value, list):
        return [_spelt(v, data) for v in value]
    if isinstance(value, str):
        try:
            F = ring(data["field"] or "QQ")
            return F.key(F(value))
        except (HFieldError, ValueError):
            return "".join(value.split())
    return value


def _norm(evidence: Any, data: Certificate) -> Any:
    F = ring(data["field"])
    w, x, y, z = map(F, evidence["value"])
    return norm(Constants(F(-1), F(0), F(-1)), (w, x, y, z))


def _zero_norm(evidence: Any, data: Certificate) -> bool:
    F = ring(data["field"])
    return F.is_zero(_norm(evidence, data)) and any(not F.is_zero(F(x)) for x in evidence["value"])


def _squares(evidence: Any, data: Certificate) -> bool:
    F = ring(data["field"])
    total = F.zero
    for text in evidence["values"]:
        total = total + F(text) * F(text)
    bound = re.search(r"level-above\{(\d+)\}", data["statement"])
    few = bound is None or len(evidence["values"]) <= int(bound[1])
    return few and F.equal(total, F(-1))


def _witness(evidence: Any, data: Certificate) -> bool:
    if "norm" in evidence:
        F = ring(data["field"])
        sign = 1 if ">" in data["statement"] else -1
        return F.equal(_norm(evidence, data), F(evidence["norm"])) and evidence["norm"] * sign < 0
    setting = read_setting(data["field"], data["algebra"])
    F = ring(name_of(evidence["ring"]))
    statement = read_statement(data["statement"], setting.field, (), setting.letters)
    values: dict[str, Any] = {text: F(text) for text in statement.constants}
    for name, _ in statement.unknowns:
        read = tuple(F(text) for text in evidence["values"][name])
        values[name] = read if len(read) == 4 else read[0]
    fixed = {text: F(text) for text in statement.constants}
    world = Evaluator(RingScalars(F), setting.trees, statement.sorts, fixed)
    world.bind(values)
    given = all(map(world.truth, statement.hypotheses))
    return (not given or bool(world.truth(statement.conclusion))) == (data["verdict"] == "proved")


def _place(evidence: Any, data: Certificate) -> bool:
    """At these values nothing exists: the prover decides the statement with the values in it."""
    field = name_of(evidence["ring"]) if "ring" in evidence else data["field"]
    values = {name: _written(texts) for name, texts in evidence["values"].items()}
    algebra = _put_in(data["algebra"], values).replace("F)", f"{field})")
    return prove(_put_in(data["statement"], values), field, (), algebra).verdict == "refuted"


def _terms(evidence: Any, data: Certificate) -> bool:
    before, _, after = data["statement"].partition("exists")
    text = _put_in(before + after.partition(":")[2], evidence["terms"])
    return prove(text, data["field"], (), data["algebra"]).verdict == "proved"


def _written(texts: list[str]) -> str:
    """Write the coordinates of an unknown as a term."""
    units = "eijk" if len(texts) == 4 else "1"
    return " + ".join(f"({c})*{u}" for c, u in zip(texts, units, strict=True))


def _put_in(text: str, values: dict[str, str]) -> str:
    """Put terms in the place of names."""
    return re.sub(r"\b[A-Za-z]\w*", lambda m: f"({values[m[0]]})" if m[0] in values else m[0], text)


def _left_out(evidence: Any, data: Certificate) -> bool:
    word, (choice, arities) = evidence["tuple"], _texts(data)
    if str(len(word)) not in arities.split(","):
        return False
    if choice == "constant":
        return len(set(word)) > 1
    return word[-1] != "e" if choice == "short" else choice == "all-but-one" and set(word) == {"k"}


def _choices(new: Any, old: Any, data: Certificate) -> bool:
    """Every choice of roots for the norms breaks the law for two of the elements."""
    F = ring(data["field"])
    c = Constants(F(-1), F(0), F(-1))
    elements = [tuple(map(F, q)) for q in new["elements"]]
    roots = {F.key(norm(c, q)): F(r) for q, r in zip(elements, new["roots"], strict=True)}
    if any(
        not F.equal(roots[F.key(norm(c, q))] * roots[F.key(norm(c, q))], norm(c, q))
        for q in elements
    ):
        return False
    for signs in product((F(1), F(-1)), repeat=len(roots)):
        chosen = {n: s * r for s, (n, r) in zip(signs, roots.items(), strict=True)}
        pairs = [(multiply(c, p, q), p, q) for p, q in product(elements, repeat=2)]
        values = [[chosen.get(F.key(norm(c, x))) for x in triple] for triple in pairs]
        if all(x is None or F.equal(x, y * z) for x, y, z in values):
            return False
    return True


def _reduced(evidence: Any) -> Any:
    """Return a table with its entries modulo the characteristic."""
    p = evidence["characteristic"]
    table = {xy: [c % p if p else c for c in v] for xy, v in evidence["table"].items()}
    value = [c % p if p else c for c in evidence["value"]]
    words = {key: [sorted(f, key=str) for f in evidence[key]] for key in ("relations", "goals")}
    return {**evidence, **words, "table": table, "value": value}


def _minor(evidence: Any, data: Certificate) -> bool:
    p = 0 if data["field"] is None else ring(data["field"]).characteristic
    rows = [[centre_equations()[r][c] for c in evidence["columns"]] for r in evidence["rows"]]
    return p == 2 or abs(int(fmpz_mat(rows).det())) in (2, 4, 8)


def _presentation(new: Any, old: Any, data: Certificate) -> bool:
    if any(new[key] != old[key] for key in ("characteristic", "identity")):
        return False
    listed = [
        [{w: c for c, w in f} for f in e[key]] for e in (new, old) for key in ("relations", "goals")
    ]
    relations, goals, *target = listed
    if [relations, goals] != target or len(new["proofs"]) != len(goals):
        return False
    p = new["characteristic"]
    for goal, proof in zip(goals, new["proofs"], strict=True):
        total = {word: -c * proof["denominator"] for word, c in goal.items()}
        for c, left, n, right in proof["cofactors"]:
            for word, d in multiply_out({(left, n, right): c}, relations).items():
                total[word] = total.get(word, 0) + d
        if any(c % p if p else c for c in total.values()) or not proof["denominator"]:
            return False
    return True
