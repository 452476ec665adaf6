"""Check the rules of a field that steps of an implication use.

Each is verified, before any step uses it. docs/explanation/trust.md has the proofs.

That polynomials lie in an ideal: sums of cofactors times its generators, multiplied out.
"""

from collections.abc import Hashable, Mapping, Sequence
from typing import Any

from hfield.checker.anisotropy import anisotropic
from hfield.checker.budget import spend, spend_products
from hfield.checker.clauses import Expansion, Formula, Fractions, Quotient, freeze
from hfield.checker.evaluate import Evaluator, Quaternion, RingScalars
from hfield.checker.language import Tree
from hfield.checker.over_field import EvaluationContext
from hfield.checker.polynomials import (
    Names,
    Poly,
    accumulate,
    add,
    constant,
    modulo,
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
from hfield.checker.scalars.finite import is_prime
from hfield.checker.scalars.ring import Ring
from hfield.checker.statement import Setting, read_setting

MAX_DEGREE = 64
MAX_FACTS = 32
# The keys of a step that says that a form is 0, so that its terms are.
FORMS = {
    "norm": ("terms", "algebra"),
    "squares": ("terms coefficients", ""),
    "binary form": ("terms coefficients", ""),
}


class Rules:
    """The facts of one implication, verified."""

    def __init__(
        self, expansion: Expansion, setting: Setting, context: EvaluationContext, facts: object
    ) -> None:
        self.expansion, self.setting, self.context = expansion, setting, context
        # By the algebra; "" is that of the statement.
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
                    reject(f"roots in {setting.field.name} are told by {setting.field.roots_by}")
                self.roots = True
            else:
                reject("a fact is of no known form, or stands there twice")

    def _norm(self, fact: Mapping[str, object], ring: Ring) -> None:
        """The norm form of an algebra over the field, that of the statement or one that is named."""
        setting, name = self.setting, ""
        if "algebra" in fact:
            name = a_text(fact["algebra"], "an algebra")
            setting = read_setting(name, ring)
        if name in self.norms:
            reject("a fact stands there twice")
        known: dict[Tree, Any] = {
            tree: ring.constant(tree)
            for tree in self.expansion.names.trees[self.expansion.unknowns :]
        }
        here = Evaluator(RingScalars(ring), setting.constants, known)
        if here.conditions or setting.letters:
            reject("the structure constants of a fact are not known")
        a, t, b = here.constants
        reason = {key: value for key, value in fact.items() if key not in ("form", "algebra")}
        self.cites |= dict.fromkeys(anisotropic(ring, (a, t, b), reason, setting.algebra))
        general = self.expansion.evaluator
        self.norms[name] = Evaluator(general.s, setting.constants, general.values)

    def _squares(self, raw: object, ring: Ring) -> None:
        """Σ c·X² is 0 only at 0, for at most ``most`` terms; with any c > 0 if ``positive``, else c = 1."""
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
        """Return a form in the terms that is 0 only where all of them are, times a number that is not 0."""
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

    def _value(self, f: Poly) -> Any:
        """Return the element of the field that a polynomial in its constants is."""
        found = self.context.coefficients(f, False)
        if not set(found) <= {()} or self.setting.field is None:
            reject("a coefficient is no element of the field")
        return found.get((), self.setting.field.zero)

    def _need_rootless(self, values: list[Hashable]) -> None:
        """Reject unless Σ cₖ·xᵏ has the degree that it seems to have, and no root in the field."""
        ring = self.setting.field
        if ring is None or not self.roots:
            reject("a step uses the fact 'roots', which is not there")
        if ring.is_zero(values[-1]):
            reject("the leading coefficient is 0")
        if not ring.has_no_root(values):
            reject("a polynomial that should have no root may have one")


MAX_DEPTH = 8


class VerifiedItem:
    """One entry of ``items`` that has been verified: zeros imply ``member``, or exclude ``nonzero``."""

    def __init__(
        self, data: object, names: Names, context: EvaluationContext, rules: Rules
    ) -> None:
        direct = isinstance(data, dict) and "member" in data
        own = "member cofactors denominator" if direct else "nonzero steps"
        item = an_object(data, f"characteristic zero relations {own}", "an item")
        self.p = an_integer(item["characteristic"], "a characteristic", 0)
        if self.p and not is_prime(self.p):
            reject(f"the characteristic {self.p} is no prime")
        if context.ring is not None and self.p not in (0, context.p):
            reject("an item is about another characteristic than the field has")
        self.modulus = self.p or context.p  # in which characteristic its equations are
        self.rules, self.denominators = rules, set[int]()
        self.zero = [names.read(z, "a polynomial of 'zero'") for z in texts(item["zero"], "zero")]
        relations = [names.read(z, "a relation") for z in texts(item["relations"], "relations")]
        for relation in relations:
            if not (context.is_constant(relation) and context.vanishes(relation)):
                reject("a relation does not hold in the field")
        self.uses_field = bool(relations)
        self.member: Poly | None = None
        self.nonzero: list[Poly] = []
        known = [*self.zero, *relations]
        if direct:
            self.member = names.read(a_text(item["member"], "member", 10**6), "a member")
            self._verify(item, known, names, self.member)
            return
        found = [
            names.read(g, "a polynomial of 'nonzero'") for g in texts(item["nonzero"], "nonzero")
        ]
        more = names.extended([f"T{n}" for n in range(1, len(found) + 1)])
        for n, g in enumerate(found, 1):
            inverse = multiply(more.variable(("name", f"T{n}")), g)
            known.append(add(constant(1), inverse, -1))
            if context.is_constant(g) and context.is_nonzero(freeze(g)):
                self.uses_field = True
            else:
                self.nonzero.append(g)
        self._steps(item["steps"], known, more, 0)

    @property
    def is_direct(self) -> bool:
        """Whether it holds over every commutative ring (denominators apart)."""
        return self.member is not None and not self.uses_field and not self.p

    def _verify(
        self, data: Mapping[str, object], known: Sequence[Poly], names: Names, target: Poly
    ) -> None:
        """Check denominator·target = Σ cofactor·known."""
        denominator = an_integer(data["denominator"], "a denominator")
        total = self._sum(data, known, names)
        if modulo(add(total, target, -denominator), self.p):
            reject("a sum of cofactors times polynomials is not what it should be")
        self._divided_by(denominator)

    def _divided_by(self, denominator: int) -> None:
        if (denominator % self.modulus if self.modulus else denominator) == 0:
            reject("a denominator is 0 in the field")
        self.denominators.add(denominator)

    def _sum(self, data: Mapping[str, object], known: Sequence[Poly], names: Names) -> Poly:
        cofactors = texts_of_polynomials(data["cofactors"])
        if len(cofactors) != len(known):
            reject(f"there are {len(cofactors)} cofactors for {len(known)} polynomials")
        total: Poly = {}
        for text, f in zip(cofactors, known, strict=True):
            accumulate(total, multiply(names.read(text, "a cofactor"), f))
        return total

    def _steps(self, data: object, known: list[Poly], names: Names, depth: int) -> None:
        """Follow the steps; the last one must complete the item."""
        steps = a_list(data, "steps", 1)
        if depth > MAX_DEPTH:
            reject("case distinctions nest too deeply")
        for number, raw in enumerate(steps, 1):
            kind = str(raw.get("step")) if isinstance(raw, dict) else ""
            own, optional = FORMS.get(kind, (_ENDS.get(kind, ""), ""))
            step = an_object(raw, f"step cofactors denominator {own}", "a step", optional)
            if kind not in FORMS and kind not in _ENDS:
                reject("a step is of no known kind")
            if (kind in _ENDS) != (number == len(steps)):
                reject("the steps do not end in a contradiction, or go on after it")
            if kind == "contradiction":
                self._verify(step, known, names, constant(1))
            elif kind == "cases":
                self._cases(step, known, names, depth)
            elif kind == "no root":
                f = names.read(a_text(step["polynomial"], "polynomial"), "a polynomial")
                self.rules.need_no_root(f)
                self._verify(step, known, names, f)
            else:
                terms = [names.read(t, "a term") for t in texts(step["terms"], "terms", 1)]
                form = self.rules.form(kind, step, terms, names)
                self._divided_by(an_integer(step["denominator"], "a denominator"))
                if not _proportional(self._sum(step, known, names), form, self.modulus):
                    reject(f"a sum of cofactors is not the form of the step {kind!r}")
                known = [*known, *terms]

    def _cases(
        self, step: Mapping[str, object], known: list[Poly], names: Names, depth: int
    ) -> None:
        factors = [names.read(f, "a factor") for f in texts(step["factors"], "factors", 1)]
        powers = [an_integer(n, "a power", 1) for n in a_list(step["powers"], "powers")]
        branches = a_list(step["branches"], "branches")
        if not len(factors) == len(powers) == len(branches):
            reject("factors, powers and branches are not equally many")
        target = constant(1)
        for f, n in zip(factors, powers, strict=True):
            if n > 64:
                reject("a power of a factor is too large")
            target = multiply(target, power(f, n))
        self._verify(step, known, names, target)
        for f, branch in zip(factors, branches, strict=True):
            self._steps(branch, [*known, f], names, depth + 1)


# The keys of a step that ends an item.
_ENDS = {"contradiction": "", "no root": "polynomial", "cases": "factors powers branches"}


def texts_of_polynomials(data: object) -> list[str]:
    """Return a list of texts that may be long."""
    return [a_text(t, "a cofactor", 10**6) for t in a_list(data, "cofactors")]


def _proportional(f: Poly, g: Poly, p: int) -> bool:
    """Tell whether f = λ·g with a number λ that is not 0 in characteristic p."""
    spend(3 * (len(f) + len(g)))
    f, g = modulo(f, p), modulo(g, p)
    if not f or not g or f.keys() != g.keys():
        return not f and not g
    top = max(f)
    c, d = f[top], g[top]
    spend_products([c, d], [*f.values(), *g.values()])
    return not any((f[m] * d - g[m] * c) % p if p else f[m] * d - g[m] * c for m in f)
