"""Whether the items of an implication's evidence are valid: its polynomials multiplied out by flint.

The part of validity.py that is about cofactors; it uses nothing of hfield.checker either.
"""

import re
from collections.abc import Mapping
from typing import Any

from flint import Ordering, fmpz_mpoly_ctx

from hfield.core.product import Constants, norm
from hfield.fields.names import ring
from hfield.prover.statements.setting import read_setting
from hfield.syntax import Reader

Certificate = dict[str, Any]
ATOM = re.compile(r"[A-Za-z]\w*(?:\[\d\]|\([^()]*\))?")


class Polynomials:
    """Reads the polynomials of an implication with flint."""

    def __init__(self, evidence: Any, characteristic: int) -> None:
        text = str(evidence["items"])
        atoms = sorted({m[0] for m in ATOM.finditer(text)} | {"T1"})
        context = fmpz_mpoly_ctx.get([f"v{n}" for n in range(len(atoms))], Ordering.degrevlex)
        self.gens = dict(zip(atoms, context.gens(), strict=True))
        self.constant, self.p = context.constant, characteristic
        self.rootless = set(re.findall(r"'polynomial': '([^']*)'", str(evidence.get("old"))))

    def read(self, text: str) -> Any:
        """Return a polynomial."""
        names: dict[str, Any] = {name: name for name in "pqruvw"}
        for n, atom in enumerate(a for a in self.gens if "(" in a):
            text = text.replace(atom, f"c{n}_")
            names[f"c{n}_"] = self.gens[atom]
        names |= {
            name: g for name, g in self.gens.items() if name.isidentifier() and name not in names
        }
        functions: Mapping[str, Any] = {
            "**": lambda x, n: x**n,
            "[]": lambda q, n: self.gens[f"{q}[{n}]"],
        }
        return Reader(self.constant, names, functions, "polynomials", 10**9).read(
            text
        ) + self.constant(0)

    def zero(self, f: Any) -> bool:
        """Tell whether f is 0 modulo the characteristic."""
        return bool(f == 0) or bool(self.p and int(f.content()) % self.p == 0)


def implication(new: Any, old: Any, data: Certificate) -> bool:
    """The new items are valid, and there is one for each of the old that is needed."""
    for fact in new["facts"]:
        if not (fact in old["facts"] or _is_idle(fact, new["items"]) or _says_less(fact, old, new)):
            return False
    field = None if data["field"] is None else ring(data["field"])
    p = 0 if field is None else field.characteristic
    both = {"items": [*new["items"], *old["items"]], "old": old}
    for item in new["items"]:
        P = Polynomials(both, item["characteristic"] or p)
        if item not in old["items"] and not _item(item, P, data):
            return False
    for item in old["items"]:
        P = Polynomials(both, item["characteristic"] or p)
        trivial = "member" in item and _among(item["member"], item["zero"], P)
        if (
            field is not None
        ):  # where a constant other than 0 would have to be 0, nothing is to be shown
            constants = [P.read(z) for z in item["zero"]]
            trivial |= any(z.is_constant() and not P.zero(z) for z in constants)
        if not trivial and not any(_serves(mine, item, P) for mine in new["items"]):
            return False
    return True


def _is_idle(fact: Any, items: Any) -> bool:
    """Tell whether no step uses a fact, or none more of it than it says."""
    steps = [s for item in items for s in item.get("steps", ()) if s["step"] == fact["form"]]
    if fact["form"] != "squares" or fact.get("most") is not None:
        return not steps and "cases" not in str(items)
    return all(c == 1 for step in steps for c in step["coefficients"])


def _says_less(fact: Any, old: Any, new: Any) -> bool:
    """Tell whether a fact is about fewer squares than one of the original, and no fewer than steps use."""
    if fact["form"] != "squares" or fact["most"] is None or "cases" in str(new["items"]):
        return False
    known = [o for o in old["facts"] if {**o, "most": None} == {**fact, "most": None}]
    steps = [s for item in new["items"] for s in item.get("steps", ()) if s["step"] == "squares"]
    return any(o["most"] is None or o["most"] >= fact["most"] for o in known) and all(
        len(s["terms"]) <= fact["most"] for s in steps
    )


def _among(f: str, texts: list[str], P: Polynomials) -> bool:
    """Tell whether f or −f is among some polynomials."""
    x = P.read(f)
    return any(P.zero(x - P.read(t)) or P.zero(x + P.read(t)) for t in texts)


def _serves(mine: Any, item: Any, P: Polynomials) -> bool:
    if mine["characteristic"] not in (0, item["characteristic"]):
        return False
    if not all(_among(z, [*item["zero"], "0"], P) for z in mine["zero"]):
        return False
    if "member" in mine:
        known = [item["member"]] if "member" in item else item["nonzero"]
        return _among(mine["member"], known, P)
    return "nonzero" in item and all(
        _among(g, item["nonzero"], P) or (P.read(g).is_constant() and not P.zero(P.read(g)))
        for g in mine["nonzero"]
    )


def _item(item: Any, P: Polynomials, data: Certificate) -> bool:
    known = [P.read(z) for z in (*item["zero"], *item["relations"])]
    if "member" in item:
        return _sum(item, known, P.read(item["member"]), P)
    for n, g in enumerate(item["nonzero"], 1):
        known.append(1 - P.gens.setdefault(f"T{n}", P.constant(0)) * P.read(g))
    return _steps(item["steps"], known, P, data)


def _sum(step: Any, known: list[Any], target: Any, P: Polynomials) -> bool:
    if len(step["cofactors"]) != len(known) or P.zero(P.constant(step["denominator"])):
        return False
    total = -step["denominator"] * target
    for text, f in zip(step["cofactors"], known, strict=True):
        total = total + P.read(text) * f
    return P.zero(total)


def _proportional(step: Any, known: list[Any], form: Any, P: Polynomials) -> bool:
    """Tell whether the sum of cofactors is the form times a number that is not 0."""
    total = P.constant(0)
    for text, f in zip(step["cofactors"], known, strict=True):
        total = total + P.read(text) * f
    for monomial, d in form.terms():
        if d % P.p if P.p else d:
            c = dict(total.terms()).get(monomial, 0)
            return bool(c % P.p if P.p else c) and P.zero(total * d - form * c)
    return P.zero(total)


def _steps(steps: list[Any], known: list[Any], P: Polynomials, data: Certificate) -> bool:
    for step in steps:
        if step["step"] == "contradiction":
            return _sum(step, known, P.constant(1), P)
        if step["step"] == "no root":  # that it has none is as in the original
            target = P.read(step["polynomial"])
            return step["polynomial"] in P.rootless and _sum(step, known, target, P)
        if step["step"] == "cases":
            target = P.constant(1)
            for f, n in zip(step["factors"], step["powers"], strict=True):
                target = target * P.read(f) ** n
            branches = zip(step["factors"], step["branches"], strict=True)
            return _sum(step, known, target, P) and all(
                _steps(branch, [*known, P.read(f)], P, data) for f, branch in branches
            )
        terms = [P.read(t) for t in step["terms"]]
        if step["step"] == "norm":
            constants = Constants(
                *(int(c) for c in read_setting(data["field"], data["algebra"]).constants)
            )
            w, x, y, z = terms
            form = norm(constants, (w, x, y, z))
        else:
            pairs = zip(step["coefficients"], terms, strict=True)
            form = sum((c * f * f for c, f in pairs), P.constant(0))
        if not _proportional(step, known, form, P):
            return False
        known = [*known, *terms]
    return False
