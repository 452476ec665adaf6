"""Elements of given norm, embeddings of quadratic orders, extremal orders, KLPT."""

import math
from random import Random

import pytest

from hfield import H, QuaternionAlgebra
from hfield.core.primality import is_prime
from hfield.errors import IndefiniteError, LatticeError, UndecidedError
from hfield.orders.quadratic_frames import frame
from hfield.orders.quadratic_orders import is_obstructed
from hfield.orders.represent_integer import represent
from hfield.orders.standard_orders import quadratic_part
from tests.orders.random_lattices import algebra
from tests.subcases import first_quick, subcases
from tests.thorough import quick_part


def prime_algebra(p: int) -> QuaternionAlgebra:
    return QuaternionAlgebra.from_ramification("QQ", [p])


def test_extremal_orders_of_every_prime() -> None:
    for p in [*(p for p in range(2, 200) if is_prime(p)), 10**6 + 3, 2**255 - 19, 27 * 2**500 - 1]:
        A = prime_algebra(p)
        O = A.extremal_order()
        assert O.is_maximal()
        q = quadratic_part(p)
        d = -q if q % 4 == 3 else -4 * q
        if p > 100:
            f = frame(O.value)
            assert f.norm == p
            assert f.discriminant == d
        # it contains the quadratic order and an element of norm p at right angles to it
        alpha = O.embeddings(d).element if p < 10**6 else frame(O.value).alpha
        assert alpha in O
    C = QuaternionAlgebra("QQ", -12 * 25, -17 * 9, 2)  # constants that do not show the order
    assert C.discriminant() == 17
    assert C.extremal_order().is_maximal()
    assert C.extremal_order().embeddings(-3)
    for wrong in (
        QuaternionAlgebra("QQ", 2, 3),
        QuaternionAlgebra.from_ramification("QQ", [2, 3, 5]),
    ):
        with pytest.raises(LatticeError, match="prime discriminant"):
            wrong.extremal_order()


def test_frames() -> None:
    rng = Random(1)
    for _ in range(40):
        A = algebra(rng, definite=True)
        O = A.maximal_order()
        f = frame(O.value)
        s = 2 * f.alpha - f.t
        assert s * s == f.discriminant
        assert s * f.beta == -(f.beta * s)
        assert f.beta.norm() == f.norm
        assert f.alpha in O
        assert f.beta in O
        x, y, z, w = (rng.randint(-9, 9) for _ in range(4))
        assert f.element(x, y, z, w).norm() == f.binary(x, y) + f.norm * f.binary(z, w)


def test_norms_of_quadratic_orders() -> None:
    for d in (-3, -4, -7, -8, -11, -15, -19, -20, -43, -163):
        t = d % 2
        n = (t - d) // 4
        for m in range(1, 150):
            found = represent(d, m)
            span = range(-2 * math.isqrt(m) - 2, 2 * math.isqrt(m) + 3)
            exists = any(x * x + t * x * y + n * y * y == m for x in span for y in span)
            if found is not None:
                x, y = found
                assert x * x + t * x * y + n * y * y == m
            elif is_prime(m):
                assert not exists, (d, m)


def test_what_a_prime_forbids_is_none() -> None:
    for D in (2, 7):
        A = prime_algebra(D)
        M = A.maximal_order()
        for f in (2, 3, 6):
            O = A.order([f * q for q in M.basis])  # ℤ + f·M: norms are squares modulo f
            for p in (2, 3):
                if f % p == 0:
                    assert is_obstructed(
                        O.value, p, p * (10**30 + 57) if p == 2 else 3 * 10**30 + 3
                    )
            assert O.represent_integer(f * (6 * 10**30 + 1)) is None
            for n in range(1, 13):
                if any(is_obstructed(O.value, p, n) for p in (2, 3, D)):
                    assert O.represent_integer(n) is None
        assert not is_obstructed(M.value, D, 10**30 + 57)


def test_norms_at_primes_where_few_ideals_are_invertible() -> None:
    """In ℤ_K + 3·O no norm is divisible by 3 alone, and those that 9 divides are the norms of 3·O."""
    O = QuaternionAlgebra("QQ(sqrt(2))", -1, -1).maximal_order()
    R = O.algebra.order([O.algebra(1), *(3 * x for x in O.basis)])
    assert R.represent_integer(6 * 101) is None
    x = R.represent_integer(9 * 101)
    assert (x.norm(), x in R) == (909, True)


def test_large_norms_over_polynomials_in_orders_that_are_not_maximal() -> None:
    """In 𝔽₂[t] + t·O norms are divisible by t² or prime to t."""
    O = QuaternionAlgebra.from_text("[1,t^3+t+1|GF(2)(t))").maximal_order()
    t = O.algebra.ring("t")
    R = O.algebra.order([O.algebra(1), *(t * x for x in O.basis)])
    n = t**9 + t + 1
    for large in (n, t**2 * n):
        x = R.represent_integer(large)
        assert (x.norm(), x in R) == (large, True)
    assert R.represent_integer(t * n) is None


def test_small_norms_are_decided() -> None:
    rng = Random(2)
    for _ in range(15):
        A = algebra(rng, definite=True, size=20)
        O = A.maximal_order()
        series = O.theta_series(40)
        for n in range(1, 41):
            found = O.represent_integer(n)
            assert (found is not None) == (series[n] > 0)
            assert found is None or (found.norm() == n and found in O)


@pytest.mark.parametrize(
    "p", first_quick([1000003, 5 * 2**248 - 1, 2**61 - 1, 2**255 - 19, 27 * 2**500 - 1], 2)
)
def test_large_norms_are_represented(p) -> None:
    O = prime_algebra(p).extremal_order()
    rng = Random(3)
    for _ in range(6):
        n = rng.randrange(p * p, 2 * p * p)
        found = O.represent_integer(n, seed=rng.randrange(10**6))
        assert found.norm() == n
        assert found in O
    assert O.represent_integer(n, seed=1) == O.represent_integer(n, seed=1)
    assert len({O.represent_integer(n, seed=s) for s in range(6)}) > 1


def test_norms_that_are_not_represented() -> None:
    p = 2**61 - 1
    O = prime_algebra(p).extremal_order()
    assert O.represent_integer(3) is None  # x² + y² + … with p too large
    other = O.random_ideal(2**61 + 15, seed=1).right_order()
    with pytest.raises(UndecidedError, match="trials"):
        other.represent_integer(2**80 + 1)
    with pytest.raises(IndefiniteError):
        QuaternionAlgebra("QQ", 2, 3).maximal_order().represent_integer(7)


@pytest.mark.slow
def test_embeddings_are_optimal_and_counted() -> None:
    rng = Random(4)
    for _ in range(12):
        A = algebra(rng, definite=True, size=15)
        O = A.maximal_order()
        small = A.lattice([1, *(2 * b for b in O.basis)]).elements_of_norm_at_most(32)
        for d in range(-32, 0):
            if d % 4 not in (0, 1):
                continue
            found = O.embeddings(d)
            assert bool(found) == (found.element is not None)
            for alpha in found.elements:
                assert alpha in O
                assert (2 * alpha - d) ** 2 == d
            # optimal: no larger order of the field lies in O, by trying all elements of trace 0
            pure = [s for s in small if s.trace() == 0 and s.norm() == -d]
            optimal = [
                s
                for s in pure
                if not any((d // m**2 + s / m) / 2 in O for m in range(2, 8) if d % m**2 == 0)
            ]
            assert len(found) == len(optimal), d
            if found:
                orbit = {u * found.element * u.inverse() for u in O.units()}
                assert len(found) >= found.orbits >= len(found) // len(orbit) // 24
    with pytest.raises(LatticeError, match="not a discriminant"):
        H("QQ").hurwitz_order().embeddings(-2)


def test_embedding_numbers_over_a_class_set() -> None:
    """Σ m(S, O_i; O_i^×) = h(S)·∏(1 − (S | p)) over the right ideal classes (Voight, theorem 30.4.7)."""
    for p in (11, 37, 53):
        C = prime_algebra(p).maximal_order().class_set()
        for d, h in (
            (-3, 1),
            (-4, 1),
            (-7, 1),
            (-8, 1),
            (-15, 2),
            (-20, 2),
            (-23, 3),
            (-47, 5),
            (-12, 1),
            (-16, 1),
        ):
            if d % p == 0:
                continue
            symbol = 1 if pow(d, (p - 1) // 2, p) == 1 else -1
            total = sum(O.embeddings(d).orbits for O in C.left_orders())
            assert total == h * (1 - symbol), (p, d)


P = 5 * 2**248 - 1


@pytest.mark.parametrize(
    ("p", "prime"), [(1019, 2), (10007, 3), (2**61 - 1, 2), (P, 2), (P, 3), (27 * 2**500 - 1, 2)]
)
def test_klpt(p, prime) -> None:
    O = prime_algebra(p).extremal_order()
    for seed in range(3):
        I = O.random_ideal(101 if p < 2000 else 2**89 - 1, seed=seed)
        J, c, e = I.equivalent_of_power_norm(prime, seed=seed)
        assert I * c == J
        assert J.norm() == prime**e
        assert J <= O
        assert J.left_order() == O
        assert e * math.log2(prime) < 3.2 * math.log2(p) + 60


@pytest.mark.slow
@subcases(
    ("p", "n", "prime"),
    [(716897, 2, 3), (716897, 7, 2), (716897, 7, 7), (905909, 2, 3), (882788248245247, 272, 17),
     (13029726666197949709, 2, 2), (2, 3, 5), (3, 2, 2), (5, 13, 2), (7, 6, 11)],
)  # fmt: skip
def test_klpt_of_small_norms(p, n, prime) -> None:
    """All short elements of such an ideal may lie in a plane, in which no norm is prime."""
    O = prime_algebra(p).extremal_order()
    for seed in quick_part(range(2)):
        I = O.random_ideal(n, seed=seed)
        J, c, e = I.equivalent_of_power_norm(prime, seed=seed)
        assert I * c == J
        assert J.norm() == prime**e
        assert J.left_order() == O


def test_klpt_of_principal_ideals_and_of_wrong_orders() -> None:
    O = prime_algebra(10007).extremal_order()
    for x in (O.basis[1] * 3 + 1, O.represent_integer(10**9 + 7)):
        J, c, e = O.left_ideal([x]).equivalent_of_power_norm(2)
        assert O.left_ideal([x]) * c == J
        assert J.norm() == 2**e
    with pytest.raises(LatticeError, match="maximal orders"):
        O.algebra.eichler_order(3).random_ideal(103, seed=1).equivalent_of_power_norm(2)
    for p, prime in (
        (2, 3),
        (3, 2),
        (5, 2),
        (7, 3),
        (13, 2),
        (17, 5),
        (73, 2),
    ):  # where frames are many
        P = prime_algebra(p).extremal_order()
        J, c, e = P.random_ideal(101, seed=p).equivalent_of_power_norm(prime)
        assert P.random_ideal(101, seed=p) * c == J
        assert J.norm() == prime**e
    with pytest.raises(LatticeError, match="other than the discriminant"):
        O.random_ideal(101, seed=1).equivalent_of_power_norm(10007)
    with pytest.raises(LatticeError, match="not a prime"):
        O.random_ideal(101, seed=1).equivalent_of_power_norm(4)
    right = O.random_ideal(101, "right", seed=1)
    J, c, e = right.equivalent_of_power_norm(2)
    assert (c * right, J.norm(), J.side) == (J, 2**e, "right")
