"""Check that polynomials lie in an ideal, or have no common zero, by sums of cofactors times generators."""

from collections.abc import Mapping, Sequence

from hfield.checker.budget import spend, spend_products
from hfield.checker.clauses import freeze
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
)
from hfield.checker.rejection import (
    a_list,
    a_text,
    an_integer,
    an_object,
    reject,
    texts,
)
from hfield.checker.rules import Rules
from hfield.checker.scalars.finite import is_prime

MAX_DEPTH = 8
# The keys of a step that states that a form is 0, so that its terms are 0.
FORMS = {
    "norm": ("terms", "algebra"),
    "squares": ("terms coefficients", ""),
    "binary form": ("terms coefficients", ""),
}


class VerifiedItem:
    """A verified entry of ``items``: the zeros imply ``member``, or exclude ``nonzero``."""

    def __init__(
        self, data: object, names: Names, context: EvaluationContext, rules: Rules
    ) -> None:
        direct = isinstance(data, dict) and "member" in data
        own = "member cofactors denominator" if direct else "nonzero steps"
        item = an_object(data, f"characteristic zero relations {own}", "an item")
        self.p = an_integer(item["characteristic"], "a characteristic", 0)
        if self.p and not is_prime(self.p):
            reject(f"the characteristic {self.p} is not a prime")
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
        """Whether the item holds over every commutative ring (apart from denominators)."""
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
    """Return whether f = λ·g for a number λ that is nonzero in characteristic p."""
    spend(3 * (len(f) + len(g)))
    f, g = modulo(f, p), modulo(g, p)
    if not f or not g or f.keys() != g.keys():
        return not f and not g
    top = max(f)
    c, d = f[top], g[top]
    spend_products([c, d], [*f.values(), *g.values()])
    return not any((f[m] * d - g[m] * c) % p if p else f[m] * d - g[m] * c for m in f)
