"""Ideals: generators, arithmetic, given norms, two-sided ones, equivalence, connecting ideals."""

import itertools
import math
import pickle
from random import Random

import pytest

from hfield import H, QuaternionAlgebra
from hfield.errors import LatticeError, TooLargeError
from hfield.orders.kernels.ideal_products import modulo_norm
from hfield.orders.lattice import Lattice
from tests.orders.brandt_by_theta import by_theta_series
from tests.orders.random_lattices import algebra, element
from tests.subcases import slow


def eichler(A, rng, levels=(1, 1, 2, 3, 4, 5, 6, 9)):
    D = A.discriminant()
    return A.eichler_order(rng.choice([n for n in levels if math.gcd(n, D) == 1]))


def test_ideals_of_prime_norm() -> None:
    rng = Random(1)
    for _ in range(12):
        A = algebra(rng, size=12)
        O = eichler(A, rng)
        for p in (2, 3, 5):
            for side in ("left", "right"):
                found = O.ideals_of_norm(p, side)
                if O.discriminant() % p:
                    assert len(found) == p + 1
                elif A.discriminant() % p == 0:
                    assert len(found) == 1
                assert len({I.hnf for I in found}) == len(found)
                for I in found:
                    assert I.norm() == p
                    assert I <= O
                    assert (O * I if side == "left" else I * O) == I
                    # the orders by the ideal against those of a bare lattice
                    assert I.left_order() == Lattice.left_order(I) == I * I.inverse()
                    assert I.right_order() == Lattice.right_order(I) == I.inverse() * I
                    assert I.right_order().is_eichler()
                    assert I.right_order().level == O.level


def test_ideals_of_composite_norm_are_counted_by_the_divisors() -> None:
    O = QuaternionAlgebra("QQ", -1, -7).maximal_order()
    for n in (4, 6, 8, 9, 12):
        found = O.ideals_of_norm(n)
        assert len(found) == sum(d for d in range(1, n + 1) if n % d == 0)
        # the elements of norm n are the generators of the principal ones: class number 1
        assert len(found) * O.unit_count() == O.theta_series(n)[n]
    with pytest.raises(TooLargeError):
        O.ideals_of_norm(2**40)


def test_ideals_of_norm_at_the_level() -> None:
    """All elements of norm p of an order of class number one, up to units."""
    A = H("QQ")
    for level, p in ((3, 3), (9, 3), (5, 5)):
        O = A.eichler_order(level)
        found = {I.hnf for I in O.ideals_of_norm(p)}
        principal = {O.left_ideal([x]).hnf for x in O.elements_of_norm(p)}
        assert found == principal if level < 9 else principal <= found


def test_ideals_of_prime_power_norm_at_the_level() -> None:
    """Not all are products of ideals of norm p; all are locally principal, and Brandt's rows count them."""
    A = H("QQ")
    for level, n in ((9, 9), (9, 3), (3, 27), (25, 25), (9, 45)):
        O = A.eichler_order(level)
        found = O.ideals_of_norm(n)
        assert len({I.hnf for I in found}) == len(found)
        assert all(I.is_invertible() and I.left_order() == O and I.norm() == n for I in found)
        assert {O.left_ideal([x]).hnf for x in O.elements_of_norm(n)} <= {I.hnf for I in found}
        assert {sum(row) for row in by_theta_series(O.class_set(), n)} == {len(found)}
    P = A.eichler_order(9).two_sided_prime(3)
    assert P.hnf in {I.hnf for I in A.eichler_order(9).ideals_of_norm(9)}


def right_ideals_of_norm(O, p):
    """The invertible ones among all lattices between O and p·O, of index p²."""
    found = set()
    for u, v in itertools.combinations(itertools.product(range(p), repeat=4), 2):
        plane = [
            sum((b * c for b, c in zip(O.basis, w, strict=True)), O.algebra(0)) for w in (u, v)
        ]
        J = O.algebra.lattice([*plane, *(b * p for b in O.basis)])
        if J.hnf not in found and O.index(J) == p * p and J * O == J:
            I = O.right_ideal(J.basis)
            if I.is_invertible() and I.norm() == p and I.right_order() == O:
                found.add(J.hnf)
    return found


@pytest.mark.slow
@pytest.mark.parametrize(("p", "count"), [(2, 12), (3, 2)])
def test_ideals_of_orders_that_are_no_eichler_orders(p, count) -> None:
    rng = Random(3)
    while count:
        A = algebra(rng, size=8)
        M = A.maximal_order()
        x = sum((b * rng.randint(-2, 2) for b in M.basis), A(0))
        O = A.order([*(b * rng.choice((1, p)) for b in M.basis), *([x] if count % 2 else [])])
        if O.is_eichler() or O.level % p:
            continue
        count -= 1
        assert {I.hnf for I in O.ideals_of_norm(p, "right")} == right_ideals_of_norm(O, p)


@pytest.mark.parametrize("n", [2, slow(3), slow(4), 6, slow(8), 9])
def test_brandt_matrices_count_them(n) -> None:
    A = QuaternionAlgebra("QQ", -1, -7)
    M = A.maximal_order()
    for O in (A.lipschitz_order(), A.order([2 * b for b in M.basis]), A.order([3 * b for b in M.basis]),
              A.order([M.basis[1], *(4 * b for b in M.basis)]),
              A.order([7 * b for b in M.basis])):  # fmt: skip
        found = O.ideals_of_norm(n, "right")
        assert len({I.hnf for I in found}) == len(found)
        assert {sum(row) for row in O.class_set().brandt_matrix(n)} == {len(found)}
        for I in found[::7]:
            assert I <= O
            assert I.norm() == n
            assert I.is_invertible()
            assert I.right_order() == O


def test_generators() -> None:
    rng = Random(2)
    for _ in range(25):
        A = algebra(rng)
        O = eichler(A, rng)
        x, y = element(A, rng), element(A, rng)
        for side, make in (("left", O.left_ideal), ("right", O.right_ideal)):
            I = make([x, y])
            plain = A.lattice([b * g if side == "left" else g * b for b in O.basis for g in (x, y)])
            assert I == plain
            assert I.side == side
        T = O.two_sided_ideal([x])
        assert T == A.lattice([b * x * c for b in O.basis for c in O.basis])
        assert O * T * O == T
    A = QuaternionAlgebra("QQ", 1, 1)
    zero = 1 + A.basis[1]
    with pytest.raises(LatticeError, match="rank below 4"):
        A.maximal_order().left_ideal([zero])
    with pytest.raises(LatticeError, match="at least one"):
        A.maximal_order().left_ideal([])


def test_two_sided_primes() -> None:
    rng = Random(3)
    for _ in range(25):
        A = algebra(rng)
        O = eichler(A, rng, (1, 2, 3, 4, 8, 9, 12, 45))
        for p in (2, 3, 5, 7):
            P = O.two_sided_prime(p)
            assert P.left_order() == O == P.right_order()
            q = math.gcd(O.discriminant(), p**20)
            if q == 1:
                assert P == p * O
            else:
                assert P.norm() == q
                assert P * P == q * O
    with pytest.raises(LatticeError, match="not a prime"):
        O.two_sided_prime(6)
    with pytest.raises(LatticeError, match="neither maximal nor"):
        H("QQ").lipschitz_order().two_sided_prime(2)


@pytest.mark.parametrize("n", [4, 8, 9, 36])
def test_random_ideals_of_powers_lie_in_no_multiple_of_the_order(n: int) -> None:
    O = QuaternionAlgebra("QQ", -1, -11).maximal_order()
    for seed in range(20):
        I = O.random_ideal(n, seed=seed)
        assert I.norm() == n
        assert I.primitive_part() == (I, 1)


def test_inverses_products_and_conjugates() -> None:
    rng = Random(4)
    for _ in range(25):
        A = algebra(rng)
        O = eichler(A, rng)
        I = O.random_ideal(10007, seed=rng.randrange(10**9))
        J = I.right_order().random_ideal(101, seed=rng.randrange(10**9))
        product = I * J
        assert product.norm() == 10007 * 101
        assert product.left_order() == O
        assert product.right_order() == J.right_order()
        assert I.conjugate().side == "right"
        for ideal in (I, I.conjugate()):
            again = pickle.loads(pickle.dumps(ideal))
            assert (again, again.side, again.order) == (ideal, ideal.side, ideal.order)
        assert I.conjugate().right_order() == O
        assert I.inverse() * product == J
        assert product * J.inverse() == I
        assert I.is_integral()
        assert not I.inverse().is_integral()
        scaled, m = (6 * I).primitive_part()
        assert (scaled, m) == (I, 6)
        with pytest.raises(LatticeError, match="integral"):
            I.inverse().primitive_part()


def test_products_by_linear_algebra_and_by_sixteen_rows() -> None:
    """Of a right and a left ideal of one order, of prime, composite and other norms, integral or not."""
    rng = Random(8)
    quick = 0
    for _ in range(60):
        A = algebra(rng)
        O = eichler(A, rng)
        D = O.discriminant()
        n, m = rng.sample(
            [n for n in (7**2, 101, 5 * 11, 2**4 * 3, 2, 9, 10007) if math.gcd(n, D) == 1], 2
        )
        I = O.random_ideal(n, "right", seed=rng.randrange(10**9))
        J = O.random_ideal(m, "left", seed=rng.randrange(10**9))
        x = element(A, rng)
        for first, second in (
            (I, J),
            (x * I, J),
            (I, J * x),
            (I, 6 * J),
            (J.conjugate(), J),
            (I, J * J.conjugate()),
        ):
            assert first * second == A.lattice([p * q for p in first.basis for q in second.basis])
            if second.side == "left" and first.side == "right" and second.is_integral():
                values = first.value, second.value, second.order.value
                quick += first.order == second.order and modulo_norm(*values) is not None
    assert quick > 100


def test_an_ideal_that_is_not_invertible() -> None:
    O = H("QQ").lipschitz_order()
    e, i, j, _ = O.basis
    I = O.left_ideal([2 * e, e + i, e + j])
    assert not I.is_invertible()
    for R in (O.right_ideal([1]), O.right_ideal([3, 1 + i + j]), O.right_ideal([1 + 2 * i])):
        assert R * I == O.algebra.lattice([p * q for p in R.basis for q in I.basis])
    with pytest.raises(LatticeError, match="not invertible"):
        I.inverse()
    x = H("QQ")(1, 2, 0, 5)
    found = I.equivalence(O.left_ideal([b * x for b in I.basis]))
    assert I * found.element == I * x


@pytest.mark.parametrize("definite", [True, False])
def test_equivalence_gives_the_element(definite) -> None:
    rng = Random(5)
    for _ in range(30):
        A = algebra(rng, definite)
        O = eichler(A, rng)
        I = O.random_ideal(10007, seed=rng.randrange(10**9))
        x = element(A, rng)
        found = I.equivalence(I * x)
        assert I * found.element == I * x
        R = I.conjugate()
        found = R.equivalence(x * R)
        assert found.element * R == x * R
        generator = O.left_ideal([x]).is_principal().element
        assert O * generator == O * x
        generator = O.right_ideal([x]).is_principal().element
        assert generator * O == x * O


def test_ideals_that_are_not_equivalent() -> None:
    """By theta series: inequivalent ones differ in the elements of least norm."""
    A = QuaternionAlgebra("QQ", -1, -103)
    O = A.maximal_order()
    ideals = O.ideals_of_norm(2) + O.ideals_of_norm(3) + O.ideals_of_norm(5)
    answers = 0
    for I in ideals:
        for J in ideals:
            found = I.equivalence(J)
            # equivalent iff I⁻¹J has an element of norm N(J)/N(I)
            between = I.inverse() * J
            assert bool(found) == (between.theta_series(1)[1] > 0)
            if found:
                assert I * found.element == J
            else:
                answers += 1
                assert "norm" in found.reason
    assert answers > 20


def test_ideals_of_different_orders_are_not_compared() -> None:
    A = QuaternionAlgebra("QQ", -1, -11)
    O = A.maximal_order()
    I = O.ideals_of_norm(3)[0]
    J = I.right_order().ideals_of_norm(5)[1]
    with pytest.raises(LatticeError, match="different orders"):
        I.equivalence(J)
    with pytest.raises(LatticeError, match="left ideal and the other a right"):
        I.equivalence(I.conjugate())
    with pytest.raises(LatticeError, match="not an ideal"):
        I.equivalence(3)
    x = A(1, 2, 0, 1)
    found = I.equivalence(A.lattice([q * x for q in I.basis]))  # a bare lattice that is one
    assert I * found.element == I * x
    with pytest.raises(LatticeError, match="not a left ideal"):
        I.equivalence(x * I.right_order() * 3)
    assert I.evidence["norm"] == "3"
    assert O.evidence["discriminant"] == 11


@pytest.mark.parametrize("definite", [True, False])
def test_connecting_ideals(definite) -> None:
    rng = Random(6)
    for _ in range(15):
        A = algebra(rng, definite)
        O = eichler(A, rng, (1, 4, 5, 6, 12, 30, 35))
        I = O.random_ideal(101, seed=rng.randrange(10**9))
        x = element(A, rng)
        for other in (I.right_order(), x * O * x.inverse(), x * I.right_order() * x.inverse()):
            J = O.connecting_ideal(other)
            assert J.left_order() == O
            assert J.right_order() == other
            assert J.is_integral()
            assert J.primitive_part()[1] == 1
    with pytest.raises(LatticeError, match="Eichler"):
        O.connecting_ideal(A.order([2 * b for b in O.basis]))


def test_pushforward_and_pullback() -> None:
    rng = Random(7)
    for _ in range(15):
        A = algebra(rng)
        O = eichler(A, rng)
        I, J = (
            O.random_ideal(101, seed=rng.randrange(10**9)),
            O.random_ideal(1009, seed=rng.randrange(10**9)),
        )
        K = I.pushforward(J)
        assert K.left_order() == I.right_order()
        assert K.norm() == 1009
        assert I * K == I & J
        assert I.pullback(K) == J
        with pytest.raises(LatticeError, match="coprime"):
            I.pushforward(I)
        with pytest.raises(LatticeError, match="pullback"):
            I.pullback(I)


def test_equivalent_ideals_of_prime_norm() -> None:
    A = QuaternionAlgebra("QQ", -1, -(5 * 2**248 - 1))
    O = A.maximal_order()
    I = O.random_ideal(2**127 - 1, seed=1)
    J, c = I.equivalent_of_prime_norm()
    assert I * c == J
    assert J.left_order() == O
    n = int(str(J.norm()))
    assert n.bit_length() < 140
    other, _ = I.equivalent_of_prime_norm(avoid=[n])
    assert other.norm() != n
    R, c = I.conjugate().equivalent_of_prime_norm()
    assert c * I.conjugate() == R


def test_random_ideals() -> None:
    A = QuaternionAlgebra("QQ", -1, -(2**89 - 1))
    O = A.maximal_order()
    norm = 2**61 - 1
    assert O.random_ideal(norm, seed=1) == O.random_ideal(norm, seed=1)
    assert len({O.random_ideal(norm, seed=n) for n in range(20)}) == 20
    assert len({O.random_ideal(2, seed=n) for n in range(40)}) == 3
    assert O.random_ideal(2**10 * 3**5, "right", seed=2).side == "right"
    I = O.random_ideal(2**10 * 3**5, seed=2)
    assert I.norm() == 2**10 * 3**5
    assert I.primitive_part()[1] == 1
    with pytest.raises(LatticeError, match="divides both"):
        O.random_ideal(O.discriminant(), seed=0)
