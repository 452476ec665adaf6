"""Orders modulo N as matrices, two generators, reduced equivalent ideals."""

import itertools
import math
import pickle
from random import Random

import pytest

from hfield import H, QuaternionAlgebra, UnfactoredError
from hfield.errors import IndefiniteError, LatticeError

A = QuaternionAlgebra("QQ", -1, -11)
O = A.maximal_order()
ORDERS = [O, A.eichler_order(9), QuaternionAlgebra(6).maximal_order(), H("QQ").hurwitz_order(),
          QuaternionAlgebra("QQ", -2, 5, 1).maximal_order()]  # fmt: skip


def product(m, n, modulus):
    return tuple(
        tuple(sum(m[r][k] * n[k][c] for k in (0, 1)) % modulus for c in (0, 1)) for r in (0, 1)
    )


def random_element(order, rng):
    return sum((rng.randint(-50, 50) * b for b in order.basis), order.algebra(0))


@pytest.mark.parametrize("order", ORDERS, ids=str)
def test_it_is_an_isomorphism_of_rings(order) -> None:
    rng = Random(1)
    d = order.discriminant()
    for n in (2, 3, 4, 5, 7, 8, 25, 30, 49, 77, 2**61 - 1):
        if math.gcd(n, d) > 1:
            continue
        M = order.modulo(n)
        for _ in range(4):
            x, y = random_element(order, rng), random_element(order, rng)
            (a, b), (c, e) = M(x)
            assert M(x * y) == product(M(x), M(y), n)
            assert (a * e - b * c - x.norm()) % n == 0
            assert (a + e - x.trace()) % n == 0
            m = tuple(tuple(rng.randrange(n) for _ in range(2)) for _ in range(2))
            assert M.lift(m) in order
            assert M(M.lift(m)) == m
        assert M(1) == ((1 % n, 0), (0, 1 % n))


@pytest.mark.parametrize("n", [2, 3, 4, 6])
def test_ideals_of_vectors_by_definition(n) -> None:
    M = O.modulo(n)
    everything = [
        sum((c * b for c, b in zip(v, O.basis, strict=True)), A(0))
        for v in itertools.product(range(n), repeat=4)
    ]
    matrices = [(x, M(x)) for x in everything]
    found = set()
    for v in itertools.product(range(n), repeat=2):
        if math.gcd(*v, n) > 1:
            with pytest.raises(LatticeError, match="not primitive"):
                M.ideal(v)
            continue
        I = M.ideal(v)
        inside = [x for x, m in matrices if all((r[0] * v[0] + r[1] * v[1]) % n == 0 for r in m)]
        assert len(inside) == n**2
        assert all(x in I for x in inside)
        assert I.norm() == n
        w = M.kernel(I)
        assert (v[0] * w[1] - v[1] * w[0]) % n == 0
        assert math.gcd(*w, n) == 1
        assert M.ideal(w) == I
        found.add(I)
    assert found == {I for I in O.ideals_of_norm(n) if I.primitive_part()[1] == 1}


def test_what_has_no_matrix_and_no_line() -> None:
    M = O.modulo(15)
    assert M(A("1/2*i")) == tuple(tuple(x * 8 % 15 for x in row) for row in M(A("i")))
    for call, message in [
        (lambda: M(A("1/3")), "not prime to 15"),
        (lambda: O.modulo(22), "factor 11 in common"),
        (lambda: O.modulo(0), "positive integer"),
        (lambda: M.lift([[1, 2, 3]]), "2 × 2"),
        (lambda: M.lift([[1, 0.5], [0, 1]]), "not an integer"),
        (lambda: M.ideal([1, 2, 3]), "2 entries"),
        (lambda: M.ideal((3, 6)), "not primitive"),
        (lambda: M.kernel(O.right_ideal([15, "1 + j"])), "not a left ideal"),
        (lambda: M.kernel(O.left_ideal([15])), "not a line"),
        (lambda: M.kernel(O.random_ideal(3, seed=1)), "not a line"),
        (lambda: M.kernel(O.random_ideal(15, seed=1) / 15), "integral"),
        (lambda: M.kernel(A.eichler_order(7).random_ideal(15, seed=1)), "not a left ideal"),
    ]:
        with pytest.raises(LatticeError, match=message):
            call()
    deeper = O.random_ideal(15 * 7 * 3, seed=1)
    assert deeper <= M.ideal(M.kernel(deeper))
    assert pickle.loads(pickle.dumps(M))(A("i")) == M(A("i"))
    assert O.modulo(1).lift([[5, 1], [0, 2]]) == 0
    primes = [2**521 - 1, 2**607 - 1]
    with pytest.raises(UnfactoredError, match="factors="):
        O.modulo(math.prod(primes))
    assert O.modulo(math.prod(primes), factors=primes)(1) == ((1, 0), (0, 1))


def ideals():
    for order in ORDERS:
        d = order.discriminant()
        for n in (2, 3, 4, 5, 6, 30, 49, 210, 2310):
            if math.gcd(n, d) == 1:
                yield order.random_ideal(n, seed=n)
                yield order.random_ideal(n, side="right", seed=n)
                yield order.random_ideal(n, seed=n) * 6 / 35
        yield order.left_ideal([1])
        for p in (2, 3, 5, 7, 11):
            if d % p or d % (p * p):
                yield order.two_sided_prime(p)
                yield from order.ideals_of_norm(p)[:2]
        for x in (order.basis[1] * 3 + 1, order.basis[2] + 2):
            if x.norm():
                yield order.left_ideal([x])
                yield order.right_ideal([x / 5])


def test_two_generators_span_the_ideal() -> None:
    number = 0
    for I in ideals():
        n, x = I.generators
        both = [n * b for b in I.order.basis]
        both += (
            [x * b for b in I.order.basis] if I.side == "right" else [b * x for b in I.order.basis]
        )
        assert I.algebra.lattice(both) == I
        number += 1
    assert number > 100


def test_ideals_that_are_not_invertible_are_refused() -> None:
    I = A.order(["3*i", "3*j"]).left_ideal([3, "3*i"])
    assert not I.is_invertible()
    with pytest.raises(LatticeError, match="not invertible"):
        _ = I.generators
    with pytest.raises(LatticeError, match="invertible ideals"):
        I.reduced_equivalent()


def test_reduced_equivalent_ideals_have_least_norm() -> None:
    for I in ideals():
        if not I.order.is_definite():
            with pytest.raises(IndefiniteError):
                I.reduced_equivalent()
            continue
        J = I.reduced_equivalent()
        assert (J.element * I if I.side == "right" else I * J.element) == J
        assert J <= I.order
        assert J.norm() == min(x.norm() for x in I.shortest()) / I.norm()
        assert J.side == I.side
        assert I.equivalence(J)
        assert pickle.loads(pickle.dumps(J)).element == J.element
        if I.is_principal():
            assert J.norm() == 1


@pytest.mark.parametrize("field", ["QQ(sqrt(5))", "QQ(sqrt(10))", "QQ[s]/(s^3-2)", "QQ(I)"])
def test_over_number_fields_the_first_generator_is_an_ideal(field) -> None:
    order = QuaternionAlgebra(field, -1, 3).maximal_order()
    K = order.algebra.ring
    for p in (5, 7):
        P = K.primes_above(p)[0]
        for I in (
            order.random_ideal(P, seed=p),
            order.random_ideal(P, "right", seed=p) * K.ideal(6),
        ):
            n, x = I.generators
            once = order.right_ideal([x]) if I.side == "right" else order.left_ideal([x])
            assert n * order + once == I


def test_over_number_fields_these_are_refused() -> None:
    K = QuaternionAlgebra("QQ(sqrt(5))", -1, -1).maximal_order()
    I = K.left_ideal([3])
    for call in (I.reduced_equivalent, lambda: K.modulo(7), lambda: I.equivalent_pair(99)):
        with pytest.raises(LatticeError, match="orders over ZZ"):
            call()
