"""R[x]/(f) for a monic f over ℤ, ℚ or GF(p), perhaps reducible, such as the dual numbers ℚ[x]/(x²).

Elements are lists of coefficients, low degree first. The checker uses only that these rings are commutative.
A quotient by an irreducible polynomial that should be a field has another kind of data.
"""

from collections.abc import Iterator, Mapping
from itertools import product

from hfield.checker.budget import spend
from hfield.checker.language import Tree
from hfield.checker.rejection import a_list, a_text, reject, shown
from hfield.checker.scalars.finite import Finite
from hfield.checker.scalars.names import blackboard, plain, polynomial_text, variables
from hfield.checker.scalars.place import E
from hfield.checker.scalars.rationals import QQ, ZZ
from hfield.checker.scalars.ring import AnyRing, Kind, ReadRing, Ring

MAX_DEGREE = 60

Dense = tuple[E, ...]  # as many coefficients as the degree of the modulus


class QuotientRing(Ring[Dense[E]]):
    """The ring ``base[variable]/(modulus)`` with a monic modulus; ℤ[I] has a separate name.

    ``field`` are the fractions of the base, with values that are those of the base where they lie in it.
    """

    def __init__(self, base: Ring[E], field: Ring[E], modulus: list[E], variable: str) -> None:
        self.base, self.degree, self.variable = base, len(modulus) - 1, variable
        self.field = field
        self.tail = [base.neg(c) for c in modulus[:-1]]
        texts = [str(c) for c in modulus]
        self.is_integral = variable == "I"
        inside = f"[{variable}]/({polynomial_text(texts, variable)})"
        self.name = "ZZ[I]" if self.is_integral else base.name + inside
        self.words = "ℤ[I]" if self.is_integral else blackboard(base.name) + inside
        self.characteristic = base.characteristic
        self.order = None if base.order is None else base.order**self.degree
        self.zero: Dense[E] = (base.zero,) * self.degree
        self.one: Dense[E] = (base.one, *self.zero[1:])
        self.generator: Dense[E] = (base.zero, base.one, *self.zero[2:])

    def number(self, n: int) -> Dense[E]:
        """Return n·1."""
        return (self.base.number(n), *self.zero[1:])

    def add(self, x: Dense[E], y: Dense[E]) -> Dense[E]:
        """Return x + y."""
        spend(self.degree)
        return tuple([self.base.add(a, b) for a, b in zip(x, y, strict=True)])

    def neg(self, x: Dense[E]) -> Dense[E]:
        """Return −x."""
        spend(self.degree)
        return tuple([self.base.neg(a) for a in x])

    def mul(self, x: Dense[E], y: Dense[E]) -> Dense[E]:
        """Return x·y, with xⁿ replaced according to the modulus."""
        base, n = self.base, self.degree
        spend(5 * n * n)
        wide = [base.zero] * (2 * n - 1)
        for i, a in enumerate(x):
            if not base.is_zero(a):
                for j, b in enumerate(y, i):
                    wide[j] = base.add(wide[j], base.mul(a, b))
        while len(wide) > n:
            top = wide.pop()
            if not base.is_zero(top):
                for k, c in enumerate(self.tail, len(wide) - n):
                    wide[k] = base.add(wide[k], base.mul(top, c))
        return tuple(wide)

    def inverse(self, x: Dense[E]) -> Dense[E] | None:
        """Return y with x·y = 1, by linear equations over the fractions of the base; None if x is
        not a unit.
        """
        columns, power = [], x
        for _ in range(self.degree):
            columns.append(power)
            power = self.mul(power, self.generator)
        y = _solution(self.field, [list(row) for row in zip(*columns, strict=True)], list(self.one))
        if y is None or not all(map(self.base.contains, y)):
            return None
        return tuple(y)

    def constant(self, tree: Tree) -> Dense[E] | None:
        """Return the class of the variable, or a constant of the base."""
        if tree == ("name", self.variable):
            return self.generator
        c = self.base.constant(tree)
        return None if c is None else (c, *self.zero[1:])

    def elements(self) -> Iterator[Dense[E]]:
        """Yield all elements, over a finite field."""
        if self.order is None:
            return super().elements()
        return iter(product(list(self.base.elements()), repeat=self.degree))


def _solution(field: Ring[E], rows: list[list[E]], right: list[E]) -> list[E] | None:
    """Return y with rows·y = right, or None if the square matrix is singular."""
    n = len(rows)
    spend(20 * n**3)
    rows = [[*row, c] for row, c in zip(rows, right, strict=True)]
    for column in range(n):
        pivot = next((k for k in range(column, n) if not field.is_zero(rows[k][column])), None)
        if pivot is None:
            return None
        rows[column], rows[pivot] = rows[pivot], rows[column]
        scale = field.need_inverse(rows[column][column])
        rows[column] = [field.mul(scale, c) for c in rows[column]]
        for k in range(n):
            factor = rows[k][column]
            if k != column and not field.is_zero(factor):
                pairs = zip(rows[k], rows[column], strict=True)
                rows[k] = [field.add(a, field.neg(field.mul(factor, b))) for a, b in pairs]
    return [row[n] for row in rows]


def _quotient_ring(data: Mapping[str, object], ring: ReadRing) -> AnyRing:
    own = plain(data, "base modulus variable")
    base = ring(own["base"])
    prime = isinstance(base, Finite) and base.is_field and base.order == base.characteristic
    if base.name not in ("ZZ", "QQ") and not prime:
        reject(f"quotients are of polynomials over ZZ, QQ or GF(p), not over {shown(base.name)}")
    texts = [
        a_text(c, "a coefficient of a modulus") for c in a_list(own["modulus"], "a modulus", 3)
    ]
    if len(texts) > MAX_DEGREE + 1:
        reject(f"the modulus of a quotient has a degree of at most {MAX_DEGREE}")
    modulus = [base.read(text) for text in texts]
    if [str(c) for c in modulus] != texts or not base.equal(modulus[-1], base.one):
        reject("a modulus is monic, its coefficients written in lowest terms, or from 0 to p − 1")
    name = own["variable"]
    if name != "I":
        (name,) = variables([name], base)
    elif base.name != "ZZ" or texts != ["1", "0", "1"]:
        reject("I is the root of −1 in ZZ[I]")
    return QuotientRing(base, QQ if base is ZZ else base, modulus, str(name))


KINDS: dict[str, Kind] = {"quotient ring": _quotient_ring}
