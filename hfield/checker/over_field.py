"""Decide when an integer polynomial is 0 over a field."""

from collections.abc import Hashable
from math import gcd

from hfield.checker.budget import spend, spend_products
from hfield.checker.clauses import Clause, Expansion, Frozen, expand
from hfield.checker.glossary import COMMUTATIVE_RINGS, FIELD, FIELDS
from hfield.checker.polynomials import (
    ONE,
    Monomial,
    Poly,
    constant,
    modulo,
    multiply,
    variables,
    width,
)
from hfield.checker.rejection import reject
from hfield.checker.scalars.ring import AnyRing
from hfield.checker.statement import Setting, Statement


class EvaluationContext:
    """A ring, or all fields of a characteristic (``p`` 0: of all characteristics at once)."""

    def __init__(self, expansion: Expansion, ring: AnyRing | None, p: int = 0) -> None:
        self.expansion, self.ring = expansion, ring
        self.p = ring.characteristic if ring is not None else p
        self._known: dict[Frozen, bool] = {}
        self._values: dict[int, Hashable] = {}
        if ring is not None:
            first = expansion.unknowns
            values = ring.named_elements(expansion.names.trees[first:])
            self._values = dict(enumerate(values.values(), first))

    def coefficients(self, f: Poly, functions: bool) -> dict[Monomial, Hashable]:
        """Return the nonzero coefficients, by the monomials in the unknowns.

        Constants of the field are substituted; with ``functions`` exponents are reduced by x^q = x.
        """
        spend(1 + 2 * len(f) + width(f))
        f, ring = modulo(f, self.p), self.ring
        if ring is None:
            return dict(f)
        q = ring.order if functions and ring.is_field else None
        out: dict[Monomial, Hashable] = {}
        for m, c in f.items():
            value, unknowns = ring.number(c), list[tuple[int, int]]()
            for v, e in m:
                if v in self._values:
                    value = ring.mul(value, ring.power(self._values[v], e))
                else:  # an unknown, or the inverse of one in an implication
                    unknowns.append((v, (e - 1) % (q - 1) + 1 if q else e))
            own = tuple(unknowns)
            out[own] = ring.add(out[own], value) if own in out else value
        return {m: c for m, c in out.items() if not ring.is_zero(c)}

    def need_algebra(self) -> None:
        """Reject if the structure constants are not defined for any values of the letters."""
        product = constant(1)
        for f in self.expansion.conditions:
            product = multiply(product, f)
        if not self.coefficients(product, True):
            reject("the structure constants of the algebra are defined nowhere")

    def vanishes(self, f: Frozen | Poly) -> bool:
        """Return whether f is 0 in the field (as a function, over a finite field)."""
        spend(1 + 2 * len(f))
        key = f if isinstance(f, frozenset) else frozenset(f.items())
        if key not in self._known:
            self._known[key] = not self.coefficients(dict(key), True)
        return self._known[key]

    def is_trivial(self, clause: Clause) -> bool:
        """Return whether all polynomials of a goal vanish, or a hypothesis is a nonzero constant."""
        if any(all(map(self.vanishes, goal)) for goal in clause.goals):
            return True
        return any(self.is_nonzero(z) for z in clause.zeros)

    def is_identity(self, clause: Clause) -> bool:
        """Return whether a clause is trivial, or the product of its single-polynomial goals and one goal
        is 0.

        If such a goal is 0, the clause is true. Over a finite field only the product may vanish.
        """
        if self.is_trivial(clause):
            return True
        if self.ring is None or not self.ring.is_field or self.ring.order is None:
            return False
        factor = constant(1)
        for goal in clause.goals:
            if len(goal) == 1:
                factor = multiply(factor, dict(*goal))
        return any(
            all(self.vanishes(multiply(factor, dict(f))) for f in goal) for goal in clause.goals
        )

    def is_nonzero(self, f: Frozen) -> bool:
        """Return whether f is a nonzero constant (for all fields: ±1)."""
        found = self.coefficients(dict(f), False)
        if set(found) != {ONE}:
            return False
        return self.ring is not None or bool(self.p) or found[ONE] in (1, -1)

    def is_constant(self, f: Poly) -> bool:
        """Return whether f is a polynomial in the constants of the named field."""
        return self.ring is not None and variables(f) <= self._values.keys()

    def same(self, f: Poly) -> Frozen:
        """Return a normal form of f up to units: its coefficients made monic."""
        spend(5 + 2 * len(f) + width(f) // 4)
        f = modulo(f, self.p)
        if not f:
            return frozenset()
        lead = f[max(f)]
        if self.p and (self.ring is None or self.ring.is_field):
            scale = pow(lead, -1, self.p)
            return frozenset((m, c * scale % self.p) for m, c in f.items())
        if self.ring is not None and self.ring.is_field:
            spend_products([lead], f.values())
            scale = gcd(*f.values()) * (1 if lead > 0 else -1)
            return frozenset((m, c // scale) for m, c in f.items())
        spend(10 * len(f))
        opposite = modulo({m: -c for m, c in f.items()}, self.p)
        return frozenset(min(f, opposite, key=lambda g: sorted(g.items())).items())


def evaluation_context(statement: Statement, setting: Setting) -> EvaluationContext:
    """Expand the statement; the algebra must exist for some values, and nonzero must mean invertible."""
    ring = setting.field
    if ring is not None and not ring.is_field and statement.divides:
        reject(f"a statement that divides is shown over {ring.name} by all cases only")
    over = EvaluationContext(expand(statement, setting), ring)
    over.need_algebra()
    return over


def reach(statement: Statement, setting: Setting) -> str:
    """Return the widest scope that a statement has by its form."""
    if setting.field is not None:
        return FIELD
    return FIELDS if statement.divides or statement.compares_unequal else COMMUTATIVE_RINGS
