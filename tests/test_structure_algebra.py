"""Algebras by their tables: associativity, unit, centre and zero divisors beside brute force."""

import itertools
import pickle
from random import Random

import pytest

from hfield import (
    CoercionError,
    H,
    MixedParentsError,
    NotationError,
    NotFiniteError,
    StructureAlgebra,
    ring,
)
from tests.subcases import first_quick

TABLE_1_1 = [
    ["e", "i", "j", "k"],
    ["i", "-e", "k", "-j"],
    ["j", "-k", "-e", "i"],
    ["k", "j", "-i", "-e"],
]
LINES = ((1, 2, 3), (1, 4, 5), (1, 7, 6), (2, 4, 6), (2, 5, 7), (3, 4, 7), (3, 6, 5))


def octonions(field: str = "QQ") -> StructureAlgebra:
    """The octonions: for each line (a, b, c) of the Fano plane e_a·e_b = e_c, and cyclically."""
    table = [[f"e{max(m, n)}" if 0 in (m, n) else "-e0" for n in range(8)] for m in range(8)]
    for line in LINES:
        for a, b, c in (line, (*line[1:], line[0]), (line[2], *line[:2])):
            table[a][b], table[b][a] = f"e{c}", f"-e{c}"
    return StructureAlgebra(field, table)


def quaternions(field: str = "QQ") -> StructureAlgebra:
    return StructureAlgebra(field, TABLE_1_1, names="e i j k")


class Brute:
    """The same algebra with integers modulo m, all of whose elements are gone through."""

    def __init__(self, m: int, table: list[list[tuple[int, ...]]]) -> None:
        self.m, self.table, self.n = m, table, len(table)
        self.elements = list(itertools.product(range(m), repeat=self.n))

        pairs = itertools.product(self.elements, repeat=2)
        self.products = {(x, y): self.multiplied(x, y) for x, y in pairs}

    def times(self, x: tuple[int, ...], y: tuple[int, ...]) -> tuple[int, ...]:
        return self.products[x, y]

    def multiplied(self, x: tuple[int, ...], y: tuple[int, ...]) -> tuple[int, ...]:
        return tuple(
            sum(x[a] * y[b] * self.table[a][b][c] for a in range(self.n) for b in range(self.n))
            % self.m
            for c in range(self.n)
        )

    def associates(self, x: tuple[int, ...], y: tuple[int, ...], z: tuple[int, ...]) -> bool:
        return self.times(self.times(x, y), z) == self.times(x, self.times(y, z))


def random_table(rng: Random, m: int, n: int) -> list[list[tuple[int, ...]]]:
    """A table with few entries, or one with a unit, or a known associative one in another basis."""
    zero = [0] * n

    def vector() -> tuple[int, ...]:
        out = list(zero)
        for _ in range(rng.randrange(3)):
            out[rng.randrange(n)] = rng.randrange(m)
        return tuple(out)

    table = [[vector() for _ in range(n)] for _ in range(n)]
    unit = [tuple(int(a == b) for b in range(n)) for a in range(n)]
    if rng.random() < 0.5:  # the first basis vector is the unit
        table[0] = list(unit)
        for a in range(n):
            table[a][0] = unit[a]
    if rng.random() < 0.3:  # idempotents, in the basis b_0 + b_1, b_1, …
        sums = [tuple(int(a == b or (a == 0 and b == 1)) for b in range(n)) for a in range(n)]
        products = [[[x * y for x, y in zip(u, v, strict=True)] for v in sums] for u in sums]
        table = [
            [tuple((w - v[0] * (c == 1)) % m for c, w in enumerate(v)) for v in row]
            for row in products
        ]
    return table


@pytest.mark.parametrize("part", first_quick(range(4), 1))
def test_random_tables_beside_brute_force(part: int) -> None:
    rng = Random(part)
    seen = set()
    for _ in range(50):
        m, n = rng.choice(((2, 2), (2, 3), (3, 2), (4, 2), (6, 2), (5, 2)))
        table = random_table(rng, m, n)
        brute = Brute(m, table)
        ground = ring(f"GF({m})" if m in (2, 3, 5) else f"ZZ/{m}")
        B = StructureAlgebra(ground, table)

        def plain(x: object) -> tuple[int, ...]:
            return tuple(int(c) for c in x.coordinates)  # type: ignore[attr-defined]

        basis = [tuple(int(a == b) for b in range(n)) for a in range(n)]
        wrong = [t for t in itertools.product(basis, repeat=3) if not brute.associates(*t)]
        found = B.is_associative()
        assert bool(found) == all(
            brute.associates(*t) for t in itertools.product(brute.elements, repeat=3)
        )
        if wrong:
            assert tuple(map(plain, found.triple or ())) == wrong[0]
        units = [
            x
            for x in brute.elements
            if all(brute.times(x, y) == y == brute.times(y, x) for y in brute.elements)
        ]
        assert ([] if B.one is None else [plain(B.one)]) == units
        centre = {
            x
            for x in brute.elements
            if all(brute.times(x, y) == brute.times(y, x) for y in basis)
            and all(
                brute.associates(*t)
                for y, z in itertools.product(basis, repeat=2)
                for t in ((x, y, z), (y, x, z), (y, z, x))
            )
        }
        generators = [plain(x) for x in B.center()]
        spanned = {
            tuple(sum(c * v[a] for c, v in zip(cs, generators, strict=True)) % m for a in range(n))
            for cs in itertools.product(range(m), repeat=len(generators))
        }
        assert spanned == centre
        zero = (0,) * n
        divisors = {
            x
            for x in brute.elements
            if any(zero in (brute.times(x, y), brute.times(y, x)) for y in brute.elements[1:])
        }
        assert {plain(x) for x in B.zero_divisors()} == divisors
        assert StructureAlgebra.from_text(str(B)) == B
        seen.add((bool(found), bool(units)))
    assert len(seen) == 4  # all four cases come up


def test_table_1_1_is_the_algebra_of_hamilton() -> None:
    B, A = quaternions(), H("QQ")
    assert B.is_associative()
    assert not B.is_commutative()
    x, y = (1, 2, 0, -3), (2, "1/2", 5, 1)
    assert (B(x) * B(y)).coordinates == tuple((A(*x) * A(*y)).coordinates)
    assert B.one == B("e")
    assert B.center() == (B.one,)
    assert B("2*i + j") * B("1 + k/2") == B("5/2*i")


@pytest.mark.parametrize(("row", "column"), list(itertools.product((1, 2, 3), repeat=2)))
def test_a_changed_sign_is_found(row: int, column: int) -> None:
    table = [list(r) for r in TABLE_1_1]
    entry = table[row][column]
    table[row][column] = entry[1:] if entry.startswith("-") else "-" + entry
    found = StructureAlgebra("QQ", table, names="e i j k").is_associative()
    assert not found
    assert found.triple is not None
    x, y, z = found.triple
    assert found.left == (x * y) * z != x * (y * z) == found.right
    assert "not associative: (" in str(found)


def test_octonions() -> None:
    B = octonions()
    found = B.is_associative()
    assert str(found) == "not associative: (e1·e2)·e4 = e7, e1·(e2·e4) = −e7"
    assert B.one == B.basis[0]
    assert B.center() == (B.one,)
    x = B([1, 2, 0, 1, 3, 0, 0, 1])
    assert not x.is_zero_divisor()
    assert octonions("GF(5)")([1, 2, 0, 0, 0, 0, 0, 0]).is_zero_divisor()  # 1 + 4 = 0


def test_elements() -> None:
    B = quaternions("GF(7)")
    e, i, j, k = B.basis
    assert i * j == k
    assert i**2 == -e
    assert 3 * i - i == 2 * i
    assert i + 1 == e + i
    assert 1 - i == e - i
    assert i + 0 == i
    assert i != j
    assert not B.zero
    assert len({i * j, k}) == 1
    assert B(3) == 3 * e
    assert str(2 * i + 6 * j) == "2*i - j"
    assert f"{i + e:latex}" == "e + i"
    assert repr(-k) == "-k"
    assert pickle.loads(pickle.dumps(i)) == i
    assert pickle.loads(pickle.dumps(B)) == B
    assert sum(1 for _ in B.zero_divisors()) == 7**3 + 7**2 - 7  # of the 2 × 2 matrices over GF(7)
    with pytest.raises(MixedParentsError):
        i * quaternions("QQ").basis[1]
    with pytest.raises(NotFiniteError):
        next(iter(quaternions().zero_divisors()))


@pytest.mark.parametrize(
    ("table", "names", "error", "words"),
    [
        ([["a", "b"]], "a b", NotationError, "1 basis vectors need 1 different names"),
        ([["a", "b"], ["b"]], "a b", CoercionError, "rows have the lengths 2, 1"),
        ([["a*a"]], "a", NotationError, "without products"),
        ([["1"]], "a", NotationError, "a number has to stand before a basis vector"),
        ([["b"]], "a", NotationError, "'b' means nothing"),
        ([[[1, 2]]], "a", CoercionError, "an element has 1 coordinates, not 2"),
        ([["a"]], "and", NotationError, "not a name of a basis vector"),
        ([], "", NotationError, "0 basis vectors"),
    ],
)
def test_what_is_no_table(
    table: list[list[str]], names: str, error: type[Exception], words: str
) -> None:
    with pytest.raises((error, NotationError), match=words.replace("*", r"\*")):
        StructureAlgebra("QQ", table, names=names)


def test_without_a_unit() -> None:
    B = StructureAlgebra("ZZ", [["2*a"]], names="a")
    assert B.one is None
    assert B("3*a") * B("a") == B("6*a")
    assert B(0) == B.zero
    with pytest.raises(CoercionError, match="has no unit"):
        B(1)
    assert StructureAlgebra("ZZ", [["-a"]], names="a").one == -StructureAlgebra(
        "ZZ", [["-a"]], names="a"
    )("a")


def test_a_text_with_a_wrong_unit() -> None:
    with pytest.raises(NotationError, match="does not give the unit, which is a"):
        StructureAlgebra.from_text("table(a, b; 1 = b: a, b; b, -a|QQ)")
