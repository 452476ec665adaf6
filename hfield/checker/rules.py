"""Check the rules of a field that steps of an implication use.

Each rule is verified before a step uses it. docs/explanation/trust.md has the proofs.
"""

from collections.abc import Hashable, Mapping

from hfield.checker.anisotropy import anisotropic
from hfield.checker.clauses import Expansion, Formula, Fractions, Quotient
from hfield.checker.evaluate import Evaluator, Quaternion, RingScalars
from hfield.checker.over_field import EvaluationContext
from hfield.checker.polynomials import (
    Names,
    Poly,
    add,
    constant,
    multiply,
    power,
    variables,
)
from hfield.checker.rejection import (
    a_list,
    a_text,
    an_integer,
    an_object,
    keyed,
    reject,
    texts,
)
from hfield.checker.scalars.ring import AnyRing
from hfield.checker.statement import Setting, read_setting

MAX_DEGREE = 64
MAX_FACTS = 32


class Rules:
    """The verified facts of one implication."""

    def __init__(
        self, expansion: Expansion, setting: Setting, context: EvaluationContext, facts: object
    ) -> None:
        self.expansion, self.setting, self.context = expansion, setting, context
        # By algebra; "" is the algebra of the statement.
        self.norms: dict[str, Evaluator[Quotient, Formula]] = {}
        self.squares: tuple[int | None, bool] | None = None  # how many; whether with coefficients
        self.roots = False
        self.cites: dict[str, None] = {}
        entries = a_list(facts, "facts")
        if len(entries) > MAX_FACTS:
            reject(f"there are {len(entries)} facts; at most {MAX_FACTS} are read")
        for entry in entries:
            fact = keyed(entry, "a fact")
            form = fact.get("form")
            if setting.field is None or not setting.field.is_field:
                reject("facts are about a field that is named")
            if form == "norm":
                self._norm(fact, setting.field)
            elif form == "squares" and self.squares is None:
                self._squares(fact, setting.field)
            elif form == "roots" and not self.roots:
                if an_object(fact, "form by", "a fact")["by"] != setting.field.roots_by:
                    reject(f"roots in {setting.field.name} are decided by {setting.field.roots_by}")
                self.roots = True
            else:
                reject("a fact is of no known form, or stands there twice")

    def _norm(self, fact: Mapping[str, object], ring: AnyRing) -> None:
        """Verify that the norm form of an algebra over the field is anisotropic; the algebra may be named."""
        setting, name = self.setting, ""
        if "algebra" in fact:
            name = a_text(fact["algebra"], "an algebra")
            setting = read_setting(name, ring)
        if name in self.norms:
            reject("a fact stands there twice")
        known = ring.named_elements(self.expansion.names.trees[self.expansion.unknowns :])
        here = Evaluator(RingScalars(ring), setting.constants, known)
        if here.conditions or setting.letters:
            reject("the structure constants of a fact are not known")
        a, t, b = here.constants
        reason = {key: value for key, value in fact.items() if key not in ("form", "algebra")}
        self.cites |= dict.fromkeys(anisotropic(ring, (a, t, b), reason, setting.algebra))
        general = self.expansion.evaluator
        self.norms[name] = Evaluator(general.s, setting.constants, general.values)

    def _squares(self, raw: object, ring: AnyRing) -> None:
        """Verify the rule that Σ c·X² is 0 only at 0, for at most ``most`` terms; c is 1, or any positive
        number if ``positive``.
        """
        fact = an_object(raw, "form by most positive", "a fact")
        positive = fact["positive"]
        if not isinstance(positive, bool):
            reject("'positive' must be true or false")
        most = None if fact["most"] is None else an_integer(fact["most"], "most", 1)
        if fact["by"] == "ordering":
            if not ring.is_ordered:
                reject(f"{ring.name} is not known to have an ordering")
        elif fact["by"] != "level" or positive or most is None or not ring.level_above(most - 1):
            reject(f"sums of squares in {ring.name} may be 0")
        self.squares = most, positive

    def form(self, kind: str, step: Mapping[str, object], terms: list[Poly], names: Names) -> Poly:
        """Return a nonzero number times a form in the terms that is 0 only if all terms are."""
        if kind == "norm":
            name = a_text(step.get("algebra", ""), "an algebra")
            if len(terms) != 4 or name not in self.norms:
                reject("the norm is that of four terms, in an algebra that a fact is about")
            lifted = Quaternion(map(Fractions.polynomial, terms))
            return dict(self.norms[name].norm(lifted)[0])
        if kind == "squares":
            return self._sum_of_squares(a_list(step["coefficients"], "coefficients"), terms)
        coefficients = [
            names.read(c, "a coefficient") for c in texts(step["coefficients"], "coefficients")
        ]
        if len(terms) != 2 or not 3 <= len(coefficients) <= MAX_DEGREE + 1:
            reject("a binary form has two terms and a degree from 2 to 64")
        self._need_rootless([self._value(c) for c in coefficients])
        degree, total = len(coefficients) - 1, constant(0)
        for k, c in enumerate(coefficients):
            product = multiply(power(terms[0], k), power(terms[1], degree - k))
            total = add(total, multiply(c, product))
        return total

    def _sum_of_squares(self, raw: list[object], terms: list[Poly]) -> Poly:
        coefficients = [an_integer(c, "a coefficient", 1) for c in raw]
        if len(coefficients) != len(terms) or self.squares is None:
            reject("a sum of squares has a coefficient for each term, and needs a fact")
        most, positive = self.squares
        if most is not None and len(terms) > most:
            reject("a sum has more squares than the fact speaks of")
        if not positive and any(c != 1 for c in coefficients):
            reject("a sum of squares has coefficients, which the fact does not allow")
        total = constant(0)
        for c, f in zip(coefficients, terms, strict=True):
            total = add(total, multiply(f, f), c)
        return total

    def need_no_root(self, f: Poly) -> None:
        """Reject a polynomial unless it is in one unknown and has no root in the field."""
        first, last = self.expansion.unknowns, len(self.expansion.names.trees)
        used = [v for v in variables(f) if not first <= v < last]
        if len(used) != 1:
            reject("a polynomial without roots must be in one unknown")
        parts: dict[int, Poly] = {}
        for m, c in f.items():
            rest = tuple(pair for pair in m if pair[0] != used[0])
            parts.setdefault(dict(m).get(used[0], 0), {})[rest] = c
        if max(parts) > MAX_DEGREE:
            reject("the degree of a polynomial without roots is too large")
        self._need_rootless([self._value(parts.get(k, {})) for k in range(max(parts) + 1)])

    def _value(self, f: Poly) -> Hashable:
        """Return the element of the field given by a polynomial in its constants."""
        found = self.context.coefficients(f, False)
        if not set(found) <= {()} or self.setting.field is None:
            reject("a coefficient is not an element of the field")
        return found.get((), self.setting.field.zero)

    def _need_rootless(self, values: list[Hashable]) -> None:
        """Reject unless Σ cₖ·xᵏ has a nonzero leading coefficient, and no root in the field."""
        ring = self.setting.field
        if ring is None or not self.roots:
            reject("a step uses the fact 'roots', which is not there")
        if ring.is_zero(values[-1]):
            reject("the leading coefficient is 0")
        if not ring.has_no_root(values):
            reject("a polynomial that should have no root may have one")
