"""Collections of elements: by brute force in small algebras, by other ways in large ones."""

from collections import Counter
from dataclasses import dataclass
from itertools import islice

import numpy as np
import pytest

from hfield import GF, QQ, H, QuaternionAlgebra, prove
from hfield.errors import CoercionError, NotFiniteError, TooLargeError, UndecidedError
from hfield.exploring.formulas import expanded
from hfield.fields.base.ring import Ring
from tests.exploring.brute_force import CASES, BruteForce, Case


@dataclass(frozen=True)
class Dual:
    """``u + v·ε`` with ε² = 0, over GF(2)."""

    u: int
    v: int

    def __add__(self, other):
        return Dual((self.u + other.u) % 2, (self.v + other.v) % 2)

    __sub__ = __add__

    def __mul__(self, other):
        return Dual(self.u * other.u, (self.u * other.v + self.v * other.u) % 2)

    def __neg__(self):
        return self


class DualNumbers(Ring):
    """A finite ring that hfield has no formulas for."""

    name, characteristic, order = "GF(2)[eps]", 2, 4

    def __call__(self, x):
        return x if isinstance(x, Dual) else Dual(x % 2, 0)

    def elements(self):
        return (Dual(n % 2, n // 2) for n in (0, 1, 2, 3))

    def is_unit(self, x):
        return x.u == 1

    def inverse(self, x):
        return x

    def annihilator(self, x):
        return None if x.u else Dual(0, 1)

    def text(self, x, style="plain"):
        return f"{x.u}+{x.v}*eps"


def numbers(elements) -> list[int]:
    return [int(n) for block in elements.numbers(block=7) for n in block]


def label(A, x) -> int:
    return [A.ring.key(y) for y in A.ring.elements()].index(A.ring.key(x))


@pytest.mark.parametrize("case", CASES, ids=str)
def test_collections_by_brute_force(case: Case) -> None:
    A, brute = case.algebra, BruteForce(case)
    everything = list(A.elements())
    table, size = brute.table, brute.q**4
    squares = table.diagonal()
    power = squares
    for _ in range(3):
        power = table[power, power]
    units = set(brute.inverses)
    expected = {
        "units": units,
        "zero_divisors": {x for x in range(size) if (table[x, 1:] == 0).any()},
        "idempotents": set(np.flatnonzero(squares == np.arange(size)).tolist()),
        "nilpotents": set(np.flatnonzero(power == 0).tolist()),
    }
    collections = [(getattr(A, name)(), want) for name, want in expected.items()]
    # N(q) = q·q̄ and tr(q) = q + q̄, both times a multiple of e
    norms, traces = Counter(), Counter()
    by_norm: dict[int, set[int]] = {}
    for n, q in enumerate(everything):
        by_norm.setdefault(label(A, q.norm()), set()).add(n)
        norms[label(A, q.norm())] += 1
        traces[label(A, q.trace())] += 1
    for n, x in enumerate(A.ring.elements()):
        collections.append((A.elements_of_norm(x), by_norm.get(n, set())))
        of_trace = A.elements_of_trace(x)
        assert len(of_trace) == of_trace.count_by_listing() == traces[n]
    for found, want in collections:
        assert numbers(found) == sorted(want)
        assert len(found) == found.count_by_listing() == found.cardinality() == len(want)
        assert list(found) == [everything[n] for n in sorted(want)]
        assert {n for n, q in enumerate(everything) if q in found} == want
        if want:
            assert found[-1] == everything[max(want)]
            assert len(set(found.sample(5))) == min(5, len(want))
            assert all(q in found for q in found.sample(5, seed=1))
            array = found.array()
            assert array.shape == (len(want),)
            assert array[len(want) // 2] == found[len(want) // 2]
        if A.ring.is_field:
            q = brute.q
            assert eval(found.formula.replace("^", "**"), {"q": q}) == len(found)


@pytest.mark.parametrize("ring", ["GF(7)", "GF(8)", "ZZ/6", "ZZ/8", "ZZ/12", "GF(9)"])
@pytest.mark.parametrize("abt", [(-1, -1, 0), (0, 1, 1), (1, 0, 0), (2, 3, 2)])
def test_formulas_against_listing(ring: str, abt: tuple[int, int, int]) -> None:
    A = QuaternionAlgebra(ring, *abt)
    scalars = [A.ring(0), A.ring(1), A.ring(-1)]
    found = [A.units(), A.zero_divisors(), A.idempotents(), A.nilpotents()]
    found += [make(x) for x in scalars for make in (A.elements_of_norm, A.elements_of_trace)]
    for elements in found:
        assert len(elements) == elements.count_by_listing()
        assert all(q in elements for q in elements.sample(3))


def test_a_ring_of_ones_own_has_collections_without_formulas() -> None:
    A = H(DualNumbers())
    assert len(A.units()) + len(A.zero_divisors()) == len(list(A.elements()))
    assert list(A.idempotents()) == [q for q in A.elements() if q * q == q]
    assert A.units().formula is None
    assert A.units().array()[3] == A.units()[3]


@pytest.mark.parametrize(
    "abt", [(-1, -1, 0), (0, 0, 0), (0, -1, 0), (-1, 0, 0), (3, 5, 1), (0, 2, 1)]
)
@pytest.mark.parametrize("q", [2053, 3**7, 2**12])
def test_large_rings_are_solved_in_the_same_order(q: int, abt: tuple[int, int, int]) -> None:
    from hfield.exploring.large_rings import solutions

    A = QuaternionAlgebra(GF(q), *abt)
    small = QuaternionAlgebra(GF({2053: 7, 3**7: 9, 2**12: 8}[q]), *abt)
    for make in ("zero_divisors", "nilpotents", "idempotents", "units"):
        found = getattr(A, make)()
        first = list(islice(found, 5))
        assert all(x in found for x in first)
        assert len(set(first)) == min(5, found.cardinality())
        other = getattr(small, make)()
        solved = list(islice(solutions(small, other.property), 200))
        assert solved == list(islice(other, 200))


def test_the_title_of_the_issue() -> None:
    assert len(list(H(GF(7)).zero_divisors())) == len(H(GF(7)).zero_divisors()) == 385


def test_formulas_are_polynomials_in_q() -> None:
    A = H(GF(5))
    assert A.units().formula == "q^4-q^3-q^2+q"
    assert A.elements_of_norm(0).formula == "q^3+q^2-q"
    assert A.idempotents().formula == "q^2+q+2"
    assert A.elements_of_trace(1).formula == "q^3"
    assert expanded("(q-1)*q^2-q^3") == "-q^2"
    assert expanded("0") == "0"
    assert H("ZZ/6").units().formula is None


@pytest.mark.parametrize("make", ["units", "zero_divisors", "idempotents", "nilpotents"])
@pytest.mark.parametrize(
    "text", ["(1,3|QQ)", "(-1,-1|QQ)", "(0,2|QQ)", "[1,t|GF(4)(t))", "(-1,-1|RR)"]
)
def test_over_infinite_fields_they_are_described_and_drawn(make: str, text: str) -> None:
    A = QuaternionAlgebra(text)
    found = getattr(A, make)()
    assert found.formula is None
    drawn = found.sample(4)
    assert drawn == found.sample(4)
    assert drawn
    assert all(q in found for q in drawn)
    statement = found.condition
    assert prove(f"{statement} => {statement}", A.ring)
    with pytest.raises(NotFiniteError):
        len(found)
    with pytest.raises(NotFiniteError):
        iter(found)


def test_elements_of_given_norm_and_trace_over_the_rationals() -> None:
    A = H(QQ)
    assert {q.norm() for q in A.elements_of_norm(7).sample(5)} == {7}
    assert {q.trace() for q in A.elements_of_trace("1/2").sample(5)} == {QQ("1/2")}
    with pytest.raises(UndecidedError, match="no element of norm"):
        A.elements_of_norm(-1).sample(1)
    assert A.elements_of_norm(A(4)).condition == "norm(q) == 4"
    with pytest.raises(CoercionError, match="scalar"):
        A.elements_of_norm(A.basis[1])


def test_what_is_not_described() -> None:
    A = H("ZZ")
    assert A.idempotents().condition == "q*q == q"
    with pytest.raises(UndecidedError, match="over fields only"):
        _ = A.units().condition
    with pytest.raises(UndecidedError, match="field of fractions"):
        A.units().sample(1)
    with pytest.raises(TooLargeError, match="iterate"):
        H(GF(1009)).units().array()
    assert "nonsense" not in A.units()
    assert H(QQ)(1) not in A.units()
