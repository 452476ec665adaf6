"""What the items of an implication share: the expansion, the field, and its facts, verified."""

from typing import Any

from hfield.certificates.clauses import Expansion, freeze
from hfield.certificates.evaluate import Evaluator, Quaternion, RingScalars
from hfield.certificates.facts import (
    has_no_rational_root,
    is_ordered,
    is_square,
    level_above,
)
from hfield.certificates.over_field import Place
from hfield.certificates.places import anisotropic
from hfield.certificates.polynomials import Names, Poly, variables
from hfield.certificates.rejection import a_list, an_integer, an_object, reject
from hfield.certificates.statement import Setting


class Context:
    """What the items of one implication share: the expansion, the field, its facts."""

    def __init__(self, expansion: Expansion, setting: Setting, facts: object) -> None:
        self.expansion, self.setting = expansion, setting
        self.names, self.ring = expansion.names, setting.field
        self.place = Place(expansion, self.ring)
        self.assumes: dict[str, None] = {}
        self.facts: dict[str, Any] = {}
        for raw in a_list(facts, "facts"):
            form = raw.get("form") if isinstance(raw, dict) else None
            keys = "form by most positive" if form == "squares" else "form by"
            fact = raw if form == "norm" else an_object(raw, keys, "a fact")
            if form not in ("norm", "squares", "roots") or form in self.facts:
                reject("a fact is of no known form, or stands there twice")
            self._verify(fact)
            self.facts[form] = fact

    def _verify(self, fact: Any) -> None:
        ring = self.ring
        if ring is None or not ring.is_field:
            reject("facts are about a field that is named")
        if fact["form"] == "norm":
            evaluator = Evaluator(RingScalars(ring), self.setting.constants, self._constants())
            if evaluator.conditions or self.setting.letters:
                reject("the structure constants are not known")
            reason = {key: value for key, value in fact.items() if key != "form"}
            values = [evaluator.term(tree)[0] for tree in self.setting.constants]
            a, t, b = values
            self.assumes.update(
                dict.fromkeys(anisotropic(ring, (a, t, b), reason, self.setting.algebra))
            )
        elif fact["form"] == "squares":
            if not isinstance(fact["positive"], bool):
                reject("'positive' must be true or false")
            most = None if fact["most"] is None else an_integer(fact["most"], "most", 1)
            if fact["positive"] or most is None:
                if not is_ordered(ring):
                    reject(f"{ring.name} is not known to have an ordering")
            else:
                if not level_above(ring, most - 1):
                    reject(f"sums of {most} squares in {ring.name} may be 0")
            if fact["by"] not in ("ordering", "level"):
                reject("the fact 'squares' is by 'ordering' or by 'level'")
        elif fact["by"] not in ("factors", "squares"):
            reject("the fact 'roots' is by 'factors' or by 'squares'")

    def _constants(self) -> dict[Any, Any]:
        ring = self.ring
        trees = self.names.trees[self.expansion.unknowns :]
        return {tree: ring.constant(tree) for tree in trees} if ring is not None else {}

    def need(self, form: str) -> Any:
        """Return a fact, or reject what uses it."""
        if form not in self.facts:
            reject(f"a step uses the fact {form!r}, which is not there")
        return self.facts[form]

    def need_squares(self, terms: int, weighted: bool) -> None:
        """Reject a sum of squares to which the fact does not apply."""
        fact = self.need("squares")
        if fact["most"] is not None and terms > fact["most"]:
            reject("a sum has more squares than the fact speaks of")
        if weighted and not fact["positive"]:
            reject("a sum of squares has coefficients, which the fact does not allow")

    def norm(self, terms: list[Poly]) -> Poly:
        """Return the numerator of the norm of four polynomials."""
        evaluator = self.expansion.evaluator
        lifted = [evaluator.s.polynomial(f) for f in terms]  # type: ignore[attr-defined]
        found: Poly = evaluator.norm(Quaternion(lifted))[0]
        return found

    def vanishes_by_constants(self, f: Poly) -> bool:
        """Tell whether a polynomial in the constants of the field is 0."""
        return self.ring is not None and (
            all(v >= self.expansion.unknowns for v in variables(f)) and self.place.vanishes(f)
        )

    def is_nonzero_constant(self, f: Poly) -> bool:
        """Tell whether f is a polynomial in the constants of the field, and not 0 there."""
        return self.ring is not None and self.place.is_nonzero(freeze(f))

    def check_rootless(self, f: Poly, names: Names) -> None:
        """Reject a polynomial unless it is in one unknown and has no root in the field."""
        self.need("roots")
        ring = self.ring
        assert ring is not None
        first, last = self.expansion.unknowns, len(self.names.trees)
        used = [v for v in variables(f) if not first <= v < last]
        if len(used) != 1:
            reject("a polynomial without roots must be in one unknown")
        degree = max(dict(m).get(used[0], 0) for m in f)
        if degree > 64:
            reject("the degree of a polynomial without roots is too large")
        values = [ring.zero] * (degree + 1)
        for m, c in f.items():
            e = dict(m).get(used[0], 0)
            rest = tuple(pair for pair in m if pair[0] != used[0])
            for value in self.place.coefficients({rest: c}, False).values():
                values[e] = ring.add(values[e], value)
        if ring.name == "QQ":
            below = 1
            for value in values:
                below *= value.denominator
            if has_no_rational_root([int(value * below) for value in values]):
                return
        elif degree == 2 and ring.characteristic != 2:
            four = ring.mul(ring.number(4), ring.mul(values[0], values[2]))
            if not is_square(ring, ring.add(ring.mul(values[1], values[1]), ring.neg(four))):
                return
        reject("a polynomial that should have no root may have one")
