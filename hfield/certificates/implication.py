"""Evidence of the kind ``implication``: cofactors, multiplied out, cover every clause."""

from collections.abc import Sequence
from itertools import product
from typing import Any

from hfield.certificates.clauses import Clause, Expansion, freeze, without_factors
from hfield.certificates.evaluate import Evaluator, RingScalars
from hfield.certificates.facts import (
    has_no_rational_root,
    is_ordered,
    is_square,
    level_above,
)
from hfield.certificates.finite import is_prime
from hfield.certificates.over_field import Place
from hfield.certificates.places import anisotropic
from hfield.certificates.polynomials import (
    BITS,
    MASK,
    Names,
    Poly,
    add,
    constant,
    is_constant,
    modulo,
    multiply,
)
from hfield.certificates.rejection import a_list, a_text, an_integer, an_object, reject, texts
from hfield.certificates.statement import Setting
from hfield.certificates.work import charge

MAX_CHOICES = 512
MAX_DEPTH = 8


class Item:
    """One entry of ``items`` that has been verified: zeros imply ``member``, or exclude ``nonzero``."""

    def __init__(self, data: object, context: "Context") -> None:
        names = context.names
        direct = isinstance(data, dict) and "member" in data
        own = "member cofactors denominator" if direct else "nonzero steps"
        item = an_object(data, f"characteristic zero relations {own}", "an item")
        self.p = an_integer(item["characteristic"], "a characteristic", 0)
        if self.p and not is_prime(self.p):
            reject(f"the characteristic {self.p} is no prime")
        if context.ring is not None and self.p not in (0, context.ring.characteristic):
            reject("an item is about another characteristic than the field has")
        self.context, self.denominators = context, set[int]()
        self.uses_field = False
        self.zero = [names.read(z, "a polynomial of 'zero'") for z in texts(item["zero"], "zero")]
        relations = [names.read(z, "a relation") for z in texts(item["relations"], "relations")]
        for relation in relations:
            if not context.vanishes_by_constants(relation):
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
            if context.is_nonzero_constant(g):
                self.uses_field = True
            else:
                self.nonzero.append(g)
        self._steps(item["steps"], known, more, 0)

    @property
    def is_direct(self) -> bool:
        """Whether it holds over every commutative ring (denominators apart)."""
        return self.member is not None and not self.uses_field and not self.p

    def _verify(self, data: Any, known: Sequence[Poly], names: Names, target: Poly) -> None:
        """Check denominator·target = Σ cofactor·known."""
        denominator = an_integer(data["denominator"], "a denominator")
        total = self._sum(data, known, names)
        if modulo(add(total, target, -denominator), self.p):
            reject("a sum of cofactors times polynomials is not what it should be")
        self._divided_by(denominator)

    def _divided_by(self, denominator: int) -> None:
        p = self.p or (self.context.ring.characteristic if self.context.ring else 0)
        if (denominator % p if p else denominator) == 0:
            reject("a denominator is 0 in the field")
        self.denominators.add(denominator)

    def _sum(self, data: Any, known: Sequence[Poly], names: Names) -> Poly:
        cofactors = texts_of_polynomials(data["cofactors"])
        if len(cofactors) != len(known):
            reject(f"there are {len(cofactors)} cofactors for {len(known)} polynomials")
        total: Poly = {}
        for text, f in zip(cofactors, known, strict=True):
            total = add(total, multiply(names.read(text, "a cofactor"), f))
        return total

    def _steps(self, data: object, known: list[Poly], names: Names, depth: int) -> None:
        """Follow the steps; the last one must complete the item."""
        steps = a_list(data, "steps", 1)
        if depth > MAX_DEPTH:
            reject("case distinctions nest too deeply")
        for number, raw in enumerate(steps, 1):
            kind = str(raw.get("step")) if isinstance(raw, dict) else ""
            step = an_object(raw, f"step cofactors denominator {_KEYS.get(kind, '')}", "a step")
            ends = kind in ("contradiction", "no root", "cases")
            if ends != (number == len(steps)):
                reject("the steps do not end in a contradiction, or go on after it")
            if kind == "contradiction":
                self._verify(step, known, names, constant(1))
            elif kind in ("norm", "squares"):
                self.uses_field = True
                terms = [names.read(t, "a term") for t in texts(step["terms"], "terms", 1)]
                self._form(kind, step, terms, known, names)
                known = [*known, *terms]
            elif kind == "no root":
                self.uses_field = True
                f = names.read(a_text(step["polynomial"], "polynomial"), "a polynomial")
                self.context.check_rootless(f, names)
                self._verify(step, known, names, f)
            elif kind == "cases":
                self._cases(step, known, names, depth)
            else:
                reject("a step is of no known kind")

    def _form(
        self, kind: str, step: Any, terms: list[Poly], known: list[Poly], names: Names
    ) -> None:
        if kind == "norm":
            if len(terms) != 4:
                reject("the norm is that of four terms")
            self.context.need("norm")
            target = self.context.norm(terms)
        else:
            coefficients = [
                an_integer(c, "a coefficient", 1)
                for c in a_list(step["coefficients"], "coefficients")
            ]
            if len(coefficients) != len(terms):
                reject("there are not as many coefficients as terms")
            self.context.need_squares(len(terms), any(c != 1 for c in coefficients))
            target = {}
            for c, f in zip(coefficients, terms, strict=True):
                target = add(target, multiply(f, f), c)
        total = self._sum(step, known, names)
        self._divided_by(an_integer(step["denominator"], "a denominator"))
        p = self.p or (self.context.ring.characteristic if self.context.ring else 0)
        if not _proportional(total, target, p):
            reject(f"a sum of cofactors is not the form of the step {kind!r}")

    def _cases(self, step: Any, known: list[Poly], names: Names, depth: int) -> None:
        factors = [names.read(f, "a factor") for f in texts(step["factors"], "factors", 1)]
        powers = [an_integer(n, "a power", 1) for n in a_list(step["powers"], "powers")]
        branches = a_list(step["branches"], "branches")
        if not len(factors) == len(powers) == len(branches):
            reject("factors, powers and branches are not equally many")
        target = constant(1)
        for f, n in zip(factors, powers, strict=True):
            if n > 64:
                reject("a power of a factor is too large")
            for _ in range(n):
                target = multiply(target, f)
        self._verify(step, known, names, target)
        for f, branch in zip(factors, branches, strict=True):
            self._steps(branch, [*known, f], names, depth + 1)


_KEYS = {
    "norm": "terms",
    "squares": "terms coefficients",
    "no root": "polynomial",
    "cases": "factors powers branches",
}


def texts_of_polynomials(data: object) -> list[str]:
    """Return a list of texts that may be long."""
    return [a_text(t, "a cofactor", 10**6) for t in a_list(data, "cofactors")]


def _proportional(f: Poly, g: Poly, p: int) -> bool:
    """Tell whether f = λ·g with a number λ that is not 0 in characteristic p."""
    f, g = modulo(f, p), modulo(g, p)
    if not f or not g or f.keys() != g.keys():
        return not f and not g
    top = max(f)
    c, d = f[top], g[top]
    return not any((f[m] * d - g[m] * c) % p if p else f[m] * d - g[m] * c for m in f)


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
            fact = an_object(raw, keys, "a fact", "places" if form == "norm" else "")
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
            values = [evaluator.term(tree)[0] for tree in self.setting.constants]
            a, t, b = values
            self.assumes.update(
                dict.fromkeys(anisotropic(ring, (a, t, b), fact, self.setting.algebra))
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
        trees = self.names.variables[self.expansion.unknowns :]
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
        from hfield.certificates.evaluate import Quaternion

        evaluator = self.expansion.evaluator
        lifted = [evaluator.s.polynomial(f) for f in terms]  # type: ignore[attr-defined]
        found: Poly = evaluator.norm(Quaternion(lifted))[0]
        return found

    def vanishes_by_constants(self, f: Poly) -> bool:
        """Tell whether a polynomial in the constants of the field is 0."""
        width = BITS * self.expansion.unknowns
        return self.ring is not None and (
            all(m & ((1 << width) - 1) == 0 for m in f) and self.place.vanishes(f)
        )

    def is_nonzero_constant(self, f: Poly) -> bool:
        """Tell whether f is a polynomial in the constants of the field, and not 0 there."""
        return self.ring is not None and self.place.is_nonzero(freeze(f))

    def check_rootless(self, f: Poly, names: Names) -> None:
        """Reject a polynomial unless it is in one unknown and has no root in the field."""
        self.need("roots")
        ring = self.ring
        assert ring is not None
        first, last = self.expansion.unknowns, len(self.names.variables)
        places = [n for n in range(len(names.variables)) if not first <= n < last]
        used = [n for n in places if any((m >> (BITS * n)) & MASK for m in f)]
        if len(used) != 1:
            reject("a polynomial without roots must be in one unknown")
        shift, width = BITS * used[0], BITS * first
        degree = max((m >> shift) & MASK for m in f)
        if degree > 64:
            reject("the degree of a polynomial without roots is too large")
        values = [ring.zero] * (degree + 1)
        for m, c in f.items():
            e = (m >> shift) & MASK
            rest = {(((m - (e << shift)) >> width) << width) if last > first else 0: c}
            found = self.place.coefficients(rest, False)
            values[e] = ring.add(values[e], found.get(0, ring.zero))
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


def check_implication(
    expansion: Expansion, setting: Setting, data: Any
) -> tuple[str, tuple[str, ...]]:
    """Check the items and that they cover the clauses; return the scope and the theorems used."""
    context = Context(expansion, setting, data["facts"])
    items = [Item(raw, context) for raw in a_list(data["items"], "items")]
    ring = setting.field
    if ring is None:
        return _everywhere(expansion, items), ()
    usable = items
    if not ring.is_field:
        usable = [item for item in items if item.is_direct and item.denominators <= {1, -1}]
        if ring.name == "ZZ" and not _divides(expansion):
            usable = items  # what holds for all elements of ℚ holds for those of ℤ
    _cover(expansion, Place(expansion, ring), usable)
    return "field", tuple(context.assumes)


def _divides(expansion: Expansion) -> bool:
    return bool(expansion.factors)


def _everywhere(expansion: Expansion, items: list[Item]) -> str:
    """Cover the clauses over all fields, and again in each characteristic that was divided by."""
    general = [item for item in items if item.p == 0]
    _cover(expansion, Place(expansion, None), general)
    divided = {abs(d) for item in general for d in item.denominators}
    primes = {item.p for item in items if item.p}
    for p in primes:
        own = [
            item
            for item in items
            if item.p == p or (not item.p and all(d % p for d in item.denominators))
        ]
        _cover(expansion, Place(expansion, None, p), own)
    for d in divided:
        for p in (*primes, *_plain_primes(expansion, d, primes, general)):
            while d % p == 0:
                d //= p
        if d != 1:
            reject("a proof over all fields divides by a number that may be 0")
    direct = all(item.is_direct for item in items) and divided <= {1}
    return "commutative rings" if direct else "fields"


def _plain_primes(expansion: Expansion, d: int, primes: set[int], general: list[Item]) -> list[int]:
    """Return small primes that divide d and in whose characteristic no item of its own is needed."""
    found = []
    for p in (n for n in range(2, 1000) if d % n == 0 and n not in primes and is_prime(n)):
        own = [item for item in general if all(m % p for m in item.denominators)]
        _cover(expansion, Place(expansion, None, p), own)
        found.append(p)
    return found


def _cover(expansion: Expansion, place: Place, items: list[Item]) -> None:
    for clause in expansion.clauses:
        if not place.is_trivial(clause) and not _covers(clause, expansion, place, items):
            reject("a case of the statement is not covered by the evidence")


def _covers(clause: Clause, expansion: Expansion, place: Place, items: list[Item]) -> bool:
    """Tell whether verified items prove the clause."""
    # Where a factor of the denominators is 0, the clause is true: so it may be divided by.
    single = {goal[0] for goal in clause.goals if len(goal) == 1}
    known = [f for f in expansion.factors if freeze(f) in single]

    def same(f: Any) -> Any:
        return place.same(without_factors(dict(f), known))

    zeros: set[Any] = {same(z) for z in clause.zeros} | {frozenset()}
    usable = [item for item in items if all(same(z) in zeros for z in item.zero)]
    members = [item.member for item in usable if item.member is not None]
    if any(is_constant(f) and place.is_nonzero(freeze(f)) for f in members):
        return True
    proved = {same(f) for f in members}
    goals = [[same(g) for g in goal if not place.vanishes(g)] for goal in clause.goals]
    if any(all(g in proved for g in goal) for goal in goals):
        return True
    if place.ring is not None and not place.ring.is_field and place.ring.name != "ZZ":
        return False
    excluded = [{same(g) for g in item.nonzero} for item in usable if item.member is None]
    excluded += [{f} for f in proved]
    for count, choice in enumerate(product(*goals)):
        if count >= MAX_CHOICES:
            reject("a case of the statement has too many branches")
        charge(len(excluded))
        if not any(part <= set(choice) for part in excluded):
            return False
    return True
