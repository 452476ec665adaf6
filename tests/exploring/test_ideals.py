"""Ideals, subalgebras, and what kind of ring an algebra is: by brute force, and by counting."""

from collections import Counter
from itertools import product

import numpy as np
import pytest

from hfield import GF, QQ, ZZ, H, QuaternionAlgebra
from hfield.errors import CoercionError, NotFiniteError, RingError, TooLargeError, UndecidedError
from hfield.fields.base.ring import Ring
from tests.exploring.brute_force import CASES, FIELDS, BruteForce, Case, cases_of
from tests.exploring.test_elements import DualNumbers
from tests.subcases import first_quick, slow
from tests.thorough import part


def sums(brute: BruteForce, left: frozenset[int], right: frozenset[int]) -> frozenset[int]:
    return frozenset(
        brute.add(np.array(sorted(left))[:, None], np.array(sorted(right))[None, :])
        .ravel()
        .tolist()
    )


def principal_ideal(brute: BruteForce, side: str, x: int) -> frozenset[int]:
    """The ideal that an element generates, as a set of numbers."""
    table = brute.table
    if side == "left":
        return frozenset(table[:, x].tolist())
    if side == "right":
        return frozenset(table[x, :].tolist())
    inside = np.zeros(brute.q**4, dtype=bool)
    inside[table[np.unique(table[:, x])]] = True
    found = frozenset(np.flatnonzero(inside).tolist())
    while len(found) < brute.q**4 and len(bigger := sums(brute, found, found)) > len(found):
        found = bigger
    return found


def all_ideals(brute: BruteForce, side: str) -> set[frozenset[int]]:
    """All sums of principal ideals, as sets of numbers."""
    principal = {principal_ideal(brute, side, x) for x in range(brute.q**4)}
    found = set(principal)
    queue = list(found)
    while queue:
        one = queue.pop()
        for other in principal:
            if not other <= one and (total := sums(brute, one, other)) not in found:
                found.add(total)
                queue.append(total)
    return found


def members(space, number: dict) -> frozenset[int]:
    """The numbers of the elements of a subspace, by linear combinations of its basis."""
    A = space.algebra
    choices = product(list(A.ring.elements()), repeat=len(space.basis))
    return frozenset(
        number[sum((q * s for q, s in zip(space.basis, c, strict=True)), A.zero)] for c in choices
    )


@pytest.mark.parametrize("case", cases_of(CASES), ids=str)
def test_ideals_by_brute_force(case: Case) -> None:
    A, brute = case.algebra, BruteForce(case)
    number = {q: n for n, q in enumerate(A.elements())}
    for found, side in (
        (A.left_ideals(), "left"),
        (A.right_ideals(), "right"),
        (A.two_sided_ideals(), "two-sided"),
    ):
        sets = [members(ideal, number) for ideal in found]
        assert set(sets) == all_ideals(brute, side)
        assert len(sets) == len(set(sets))
        assert found[0].basis == ()
        assert found[-1].dimension == 4
        for ideal, inside in zip(found, sets, strict=True):
            assert ideal.side == side
            assert ideal.cardinality() == len(inside)
            assert all((q in ideal) == (n in inside) for q, n in list(number.items())[::7])
            assert [ideal <= other for other in found] == [inside <= other for other in sets]
            if ideal.generator is not None:
                assert number[ideal.generator] in inside
                assert not any(number[ideal.generator] in other for other in sets if other < inside)


@pytest.mark.parametrize("case", FIELDS, ids=str)
def test_subalgebras_by_brute_force(case: Case) -> None:
    A, brute = case.algebra, BruteForce(case)
    number = {q: n for n, q in enumerate(A.elements())}
    units = sorted(brute.inverses)
    table = brute.table
    for dimension in (1, 2, 3, 4):
        found = A.subalgebras(dimension=dimension)
        sets = [frozenset(members(s, number) for s in one.conjugates) for one in found]
        for orbit in sets:
            first = np.array(sorted(next(iter(orbit))))
            conjugates = (table[table[u, first], brute.inverses[u]] for u in units)
            assert orbit == {frozenset(c.tolist()) for c in conjugates}
            assert brute.one in first
            assert set(table[np.ix_(first, first)].ravel().tolist()) == set(first.tolist())
        total = sum(map(len, sets))
        assert total == len(frozenset().union(*sets))
        if dimension == 2:
            assert total == brute.q**2 + brute.q + 1
            for one in found:
                inside = sorted(members(one, number))
                squares = [int(table[x, x]) for x in inside]
                nilpotents = squares.count(0)
                idempotents = sum(x == y for x, y in zip(inside, squares, strict=True))
                kinds = {(1, 2): "field", (1, 4): "split", (brute.q, 2): "dual numbers"}
                assert one.kind == kinds[nilpotents, idempotents]
        if dimension == 3:
            for one in found:
                idempotents = sum(int(table[x, x]) == x for x in members(one, number))
                assert one.kind == ("local" if idempotents == 2 else "triangular matrices")


Numbers = tuple[int, ...]


class Residues:
    """An algebra over ℤ/n by formulas on rows of integers, its submodules as ascending numbers."""

    def __init__(self, n: int, a: int, t: int, b: int) -> None:
        self.n, self.constants = n, (a, t, b)
        self.elements = np.array(list(product(range(n), repeat=4)))
        self.weights = np.array([n**3, n**2, n, 1])

    def times(self, p: np.ndarray, q: np.ndarray) -> np.ndarray:
        """(w + xi + (y + zi)j)(c + di + (e + fi)j), with ju = (conjugate of u)j, i² = a + ti, j² = b."""
        a, t, b = self.constants
        w, x, y, z = p
        c, d, e, f = q

        def multiply(u, v):
            return np.array(
                [u[0] * v[0] + a * u[1] * v[1], u[0] * v[1] + u[1] * v[0] + t * u[1] * v[1]]
            )

        def bar(u):
            return u[0] + t * u[1], -u[1]

        scalar = multiply((w, x), (c, d)) + b * multiply((y, z), bar((e, f)))
        vector = multiply((w, x), (e, f)) + multiply((y, z), bar((c, d)))
        return np.concatenate([scalar, vector])

    def span(self, rows) -> Numbers:
        """All sums of multiples of rows."""
        inside = np.zeros(self.n**4, dtype=bool)
        inside[0] = True
        for row in rows:
            if inside[np.asarray(row) % self.n @ self.weights]:
                continue
            found = self.elements[inside]
            multiples = np.arange(self.n)[:, None] * np.asarray(row)[None]
            sums = (found[:, None] + multiples[None]).reshape(-1, 4) % self.n
            inside[sums @ self.weights] = True
        return tuple(np.flatnonzero(inside).tolist())

    def principal(self, side: str) -> dict[Numbers, list[np.ndarray]]:
        """The ideals that one element generates, with rows that span them."""
        found, basis = {}, np.eye(4, dtype=int)
        for x in self.elements:
            if any(x) and self.n % next(c for c in x if c):
                continue  # a unit of ℤ/n times another x
            rows = [self.times(u, x) if side == "left" else self.times(x, u) for u in basis]
            found.setdefault(self.span(rows), rows)
        return found

    def sums(self, principal: dict[Numbers, list[np.ndarray]]) -> set[Numbers]:
        """All sums of ideals."""
        found, queue = dict(principal), list(principal)
        while queue:
            one = queue.pop()
            for rows in principal.values():
                both = [*found[one], *rows]
                if (total := self.span(both)) not in found:
                    found[total] = both
                    queue.append(total)
        return set(found)


@pytest.mark.parametrize(
    ("n", "a", "t", "b"),
    first_quick(part([(6, -1, 0, -1), (8, -1, 0, -1), (9, 3, 0, -1), (6, 0, 1, 3)], 2), 1),
)
@pytest.mark.parametrize("side", ["left", "right"])
def test_ideals_over_residues_by_brute_force(n: int, a: int, t: int, b: int, side: str) -> None:
    A, brute = QuaternionAlgebra(f"ZZ/{n}", a, b, t), Residues(n, a, t, b)
    found = A.left_ideals() if side == "left" else A.right_ideals()
    spans = [brute.span([[int(x) for x in q.coordinates] for q in ideal.basis]) for ideal in found]
    principal = brute.principal(side)
    assert set(spans) == brute.sums(principal)
    assert len(spans) == len(set(spans))
    for ideal, span in zip(found, spans, strict=True):
        assert len(span) == ideal.cardinality()
        assert (ideal.generator is not None) == (span in principal)


@pytest.mark.parametrize("ring", ["ZZ/4", "ZZ/6", slow("ZZ/9")])
def test_two_sided_ideals_over_residues(ring: str) -> None:
    for abt in ((-1, -1, 0), (0, 0, 0), (1, 3, 1)):
        A = QuaternionAlgebra(ring, *abt)
        both = set(A.left_ideals()) & set(A.right_ideals())  # equal as modules
        assert set(A.two_sided_ideals()) == both


@pytest.mark.parametrize("case", cases_of(c for c in CASES if c.ring == "ZZ/4"), ids=str)
def test_subalgebras_over_residues_by_brute_force(case: Case) -> None:
    A, brute = case.algebra, BruteForce(case)
    number = {q: n for n, q in enumerate(A.elements())}
    table, scalars = brute.table, brute.one * np.arange(4)
    # subgroups that contain 1, one more generator at a time; then those closed under the product
    subgroups = {frozenset(scalars.tolist())}
    cyclic = {frozenset(int(brute.scale(s, np.array(x))) for s in range(4)) for x in range(256)}
    queue = list(subgroups)
    while queue:
        one = queue.pop()
        for multiples in cyclic:
            if not multiples <= one and (total := sums(brute, one, multiples)) not in subgroups:
                subgroups.add(total)
                queue.append(total)
    expected = {s for s in subgroups if set(table[np.ix_(sorted(s), sorted(s))].ravel()) <= s}
    found = [s for d in (1, 2, 3, 4) for s in A.subalgebras(dimension=d)]
    sets = [frozenset(members(s, number) for s in one.conjugates) for one in found]
    assert frozenset().union(*sets) == expected
    assert sum(map(len, sets)) == len(expected)
    units = sorted(brute.inverses)
    for one, orbit in zip(found, sets, strict=True):
        inside = sorted(members(one, number))
        conjugates = (table[table[u, inside], brute.inverses[u]] for u in units)
        assert orbit == {frozenset(c.tolist()) for c in conjugates}
        idempotents = sum(int(table[x, x]) == x for x in inside)
        if len(inside) < 256:
            assert (one.kind == "local") == (idempotents == 2)
    assert sum(s.kind == "the algebra" for s in found) == 1


def test_kinds_of_subalgebras_over_residues() -> None:
    kinds = Counter(s.kind for s in H("ZZ/6").subalgebras())
    assert kinds == {"product of 2 local rings": 23, "product of 3 local rings": 8}
    assert "neither local nor commutative" in {s.kind for s in H("ZZ/9").subalgebras(dimension=3)}


@pytest.mark.parametrize("case", [c for c in FIELDS if c.ring in ("GF(2)", "GF(3)")], ids=str)
def test_all_subalgebras_of_dimension_3_are_found(case: Case) -> None:
    A, brute = case.algebra, BruteForce(case)
    q, table = brute.q, brute.table
    count = 0
    for form in product(range(q), repeat=3):
        if form < (0, 0, 1) or next(x for x in form if x) != 1:
            continue
        value = np.zeros(q**4, dtype=int)
        for coefficient, column in zip(form, brute.digits.T[1:], strict=True):
            value = brute.sums[value, brute.products[coefficient, column]]
        inside = np.flatnonzero(value == 0)
        count += not set(table[np.ix_(inside, inside)].ravel().tolist()) - set(inside.tolist())
    assert sum(len(s.conjugates) for s in A.subalgebras(dimension=3)) == count


@pytest.mark.parametrize("case", cases_of(CASES), ids=str)
def test_kinds_of_rings_by_brute_force(case: Case) -> None:
    A, brute = case.algebra, BruteForce(case)
    units = np.zeros(brute.q**4, dtype=bool)
    units[list(brute.inverses)] = True
    minus = np.array(
        [
            int(brute.add(np.array(0), brute.scale(brute.minus[1], np.array(x))))
            for x in range(brute.q**4)
        ]
    )
    # x is in the radical when 1 − ax is a unit for all a
    radical = [
        x
        for x in range(brute.q**4)
        if units[brute.add(np.array(brute.one), minus[brute.table[:, x]])].all()
    ]
    assert A.is_semisimple() == (radical == [0])
    others = np.flatnonzero(~units)
    assert A.is_local() == (not units[brute.add(others[:, None], others[None, :])].any())
    generated = (principal_ideal(brute, "two-sided", x) for x in range(1, brute.q**4))
    assert A.is_simple() == all(len(ideal) == brute.q**4 for ideal in generated)


@pytest.mark.parametrize(
    ("text", "simple", "semisimple", "local"),
    [
        ("(-1,-1|QQ)", True, True, True),
        ("(1,1|QQ)", True, True, False),
        ("(0,2|QQ)", False, False, True),
        ("(0,4|QQ)", False, False, False),
        ("(2,0|QQ)", False, False, True),
        ("(0,0|QQ)", False, False, True),
        ("[1,0|GF(2)(t))", False, False, True),
        ("[0,0|GF(2)(t))", False, False, False),
        ("(t,t|GF(2)(t))", False, False, True),
        ("(-1,-1|ZZ)", False, False, False),
    ],
)
def test_kinds_over_infinite_rings(text: str, simple: bool, semisimple: bool, local: bool) -> None:
    A = QuaternionAlgebra(text)
    assert (A.is_simple(), A.is_semisimple(), A.is_local()) == (simple, semisimple, local)


def test_larger_split_algebras() -> None:
    A = H(GF(31))
    ideals = A.left_ideals()
    assert Counter(ideal.dimension for ideal in ideals) == {0: 1, 2: 32, 4: 1}
    assert len(set(ideals)) == len(ideals)
    zero_divisors = list(A.zero_divisors().sample(20))
    for x in zero_divisors:
        assert sum(x in ideal for ideal in ideals[1:-1]) == 1 or not x
    assert [(s.kind, len(s.conjugates)) for s in H(GF(7)).subalgebras(dimension=3)] == [
        ("triangular matrices", 8)
    ]


def test_over_infinite_fields() -> None:
    A = H(QQ)
    assert [ideal.dimension for ideal in A.left_ideals()] == [0, 4]
    assert len(QuaternionAlgebra(QQ, 1, 1).two_sided_ideals()) == 2
    for make in (
        QuaternionAlgebra(QQ, 1, 1).left_ideals,
        QuaternionAlgebra(QQ, 0, 1).two_sided_ideals,
        A.subalgebras,
    ):
        with pytest.raises(NotFiniteError):
            make()


def test_what_is_refused() -> None:
    with pytest.raises(RingError, match="finite fields and ZZ/n"):
        H(DualNumbers()).left_ideals()
    with pytest.raises(TooLargeError, match="among 262144"):
        H("ZZ/64").left_ideals()
    with pytest.raises(TooLargeError, match=r"among \d+ submodules"):
        H("ZZ/60").subalgebras()
    with pytest.raises(NotFiniteError):
        H(ZZ).left_ideals()
    with pytest.raises(CoercionError, match="dimension"):
        H(GF(3)).subalgebras(dimension=5)
    with pytest.raises(TooLargeError):
        H(GF(1009)).subalgebras()
    with pytest.raises(TooLargeError):
        H(GF(10**9 + 7)).left_ideals()
    assert H(GF(2)).left_ideals()[0] != "nothing"
    assert "nonsense" not in H(GF(2)).left_ideals()[0]

    class Infinite(Ring):
        name, characteristic = "infinite", 0

        def __call__(self, x):
            return x

    for ask in (H(Infinite()).is_semisimple, H(Infinite()).is_local):
        with pytest.raises(UndecidedError):
            ask()
