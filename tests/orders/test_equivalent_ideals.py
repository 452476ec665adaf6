"""KLPT to norms that divide a number, pairs of norms with a given sum, and the steps of both."""

import itertools
import math
import re
from random import Random

import pytest

from hfield import QuaternionAlgebra
from hfield.errors import (
    IndefiniteError,
    LatticeError,
    NoEquivalentIdealError,
    NoSolutionError,
    UndecidedError,
)
from hfield.orders.allowed_norms import Divisors

P = 5 * 2**248 - 1


def algebra(p: int) -> QuaternionAlgebra:
    return QuaternionAlgebra.from_ramification("QQ", [p])


def moved(I, c):
    return c * I if I.side == "right" else I * c


def check_dividing(I, number, **options) -> int:
    J, c, n = I.equivalent_of_norm_dividing(number, **options)
    assert moved(I, c) == J
    assert J.norm() == n
    assert number % n == 0
    assert J <= I.order
    assert (J.side, J.order) == (I.side, I.order)
    return n


def check_pair(I, total, **options) -> None:
    (J, c), (K, d) = I.equivalent_pair(total, **options)
    assert (moved(I, c), moved(I, d)) == (J, K)
    assert J.norm() + K.norm() == total
    assert math.gcd(J.norm(), K.norm()) == 1
    assert J <= I.order
    assert K <= I.order


SMOOTH = math.prod(p**e for p, e in ((2, 9), (3, 40), (5, 21), (7, 7), (79, 3))) * math.prod(
    p for p in range(11, 700) if all(p % q for q in range(2, p))
)


@pytest.mark.parametrize(
    ("p", "number"), [(2**61 - 1, SMOOTH), (P, SMOOTH), (P, 2**800), (10**9 + 9, 6**60)]
)
def test_norms_that_divide_a_smooth_number(p, number) -> None:
    O = algebra(p).extremal_order()
    for seed, side in enumerate(("left", "right")):
        assert check_dividing(O.random_ideal(101, side, seed=seed), number, seed=seed) < 16 * p**4


def test_from_orders_that_are_not_extremal() -> None:
    p = 2**61 - 1
    O = algebra(p).extremal_order().random_ideal(2**89 - 1, seed=5).right_order()
    for side in ("left", "right"):
        I = O.random_ideal(103, side, seed=1) / 7
        assert check_dividing(I, p * 2**480) < 2**480
        J, c, e = I.equivalent_of_power_norm(2)
        assert (moved(I, c), J.norm()) == (J, 2**e)


def least_divisor(I, number):
    """Return the least norm of an equivalent ideal that divides a number, by listing elements."""
    return next(
        (n for n in range(1, number + 1) if number % n == 0 and I.elements_of_norm(n * I.norm())),
        None,
    )


@pytest.mark.parametrize("p", [2, 11, 37])
def test_small_numbers_are_decided_as_a_search_decides(p) -> None:
    rng = Random(p)
    orders = [algebra(p).extremal_order()]
    orders.append(orders[0].random_ideal(1009, seed=1).right_order())
    for O, number in itertools.product(orders, (1, 2, 12, 30, 2 * p, p**2, 97)):
        I = O.random_ideal(rng.choice([n for n in (1, 5, 7, 101) if n % p]), seed=rng.randrange(99))
        least = least_divisor(I, number)
        if least is not None:
            assert check_dividing(I, number) == least
            continue
        with pytest.raises(NoEquivalentIdealError, match=r"all its divisors were tried.*\d+ bits"):
            I.equivalent_of_norm_dividing(number)


@pytest.mark.parametrize("discriminant", [30, 42, 105])
def test_numbers_that_share_some_primes_with_the_discriminant(discriminant) -> None:
    """Elements of even norm lie in one two-sided prime ideal, and need none of those at other primes."""
    O = QuaternionAlgebra(discriminant).maximal_order()
    for norm, factor in itertools.product((13, 17, 19), (1, 2, 7, discriminant)):
        I = O.random_ideal(norm, seed=norm)
        least = least_divisor(I, factor * discriminant)
        if least is not None:
            assert check_dividing(I, factor * discriminant) == least
            continue
        with pytest.raises(NoEquivalentIdealError):
            I.equivalent_of_norm_dividing(factor * discriminant)


def test_a_proof_where_no_order_is_extremal() -> None:
    """KLPT is for algebras of prime discriminant: the error names no size of numbers for it."""
    O = QuaternionAlgebra(102).maximal_order().random_ideal(1009, seed=0).right_order()
    with pytest.raises(NoEquivalentIdealError, match="prime discriminant, and this is 102"):
        O.random_ideal(19, seed=0).equivalent_of_norm_dividing(1)


@pytest.mark.parametrize("number", [2**89 - 1, 1048571**2, 137 * (2**61 - 1)])
def test_large_numbers_of_few_divisors(number) -> None:
    O = algebra(137).extremal_order()
    for order in (O, O.random_ideal(1013, seed=3).right_order()):
        check_dividing(order.random_ideal(101, seed=1), number)


@pytest.mark.parametrize("p", [2, 13, 419, 1048573, 2**61 - 1, P, 27 * 2**500 - 1])
def test_pairs_of_norms_with_a_sum(p) -> None:
    O = algebra(p).extremal_order()
    rng = Random(p)
    bits = p.bit_length()
    for total in (2 * p + 3, 2 ** (bits + 1), 2 ** (bits + 1) + 1, 2 ** max(300, bits + 90) + 1):
        if total > p:
            check_pair(O.random_ideal(103, rng.choice(["left", "right"]), seed=1) / 5, total)


@pytest.mark.parametrize("norm", [2**64, 4, 210**9, 3**40])
def test_pairs_where_the_norms_of_all_short_elements_share_a_factor_with_the_sum(norm) -> None:
    I = algebra(P).extremal_order().random_ideal(norm, seed=1)
    for total in (2**252, 2 * P + 105, 105 * 2**246):
        check_pair(I, total)


@pytest.mark.parametrize(
    ("p", "number"),
    [(248867, 18949367), (869299, 5266695113), (985493, 2**91 + 279), (14281, 2**81 + 17)],
)
def test_numbers_of_all_sizes_for_any_order(p, number) -> None:
    """A prime of middle size has one divisor that may be a norm, and no structure of the order helps."""
    O = algebra(p).extremal_order().random_ideal(2**61 - 1, seed=5).right_order()
    I = O.random_ideal(5, seed=1)
    assert check_dividing(I, number) > 1
    check_pair(I, number)
    x = O.represent_integer(p * number)
    assert (x.norm(), x in O) == (p * number, True)


def test_the_size_that_a_refusal_names_suffices() -> None:
    """The short elements of the second ideal have even norms, which leaves KLPT a long prime only."""
    O = algebra(P).extremal_order()
    for I in (O.random_ideal(101, seed=1), O.random_ideal(4, seed=1)):
        with pytest.raises(UndecidedError) as refused:
            I.equivalent_of_norm_dividing(3**60 * 5**60)
        bits = int(re.search(r"T > 2\^(\d+)", str(refused.value))[1])
        assert check_dividing(I, 3**60 * 5 ** math.ceil((bits - 95) / math.log2(5))) < 2 ** (
            bits + 5
        )


def test_pairs_of_norms_elsewhere_and_what_has_none() -> None:
    for p in (1009, 10**6 + 3):
        O = algebra(p).extremal_order().random_ideal(101, seed=4).right_order()
        check_pair(O.random_ideal(3**9, seed=1), 2 * p + 5)
    O = algebra(P).extremal_order()
    I = O.random_ideal(101, seed=1)
    with pytest.raises(UndecidedError, match=r"about 2·p"):
        I.equivalent_pair(P // 2**40)
    with pytest.raises(LatticeError, match="p-extremal"):
        O.random_ideal(2**89 - 1, seed=1).right_order().random_ideal(3).equivalent_pair(2**260)
    check_pair(O.left_ideal([1]), 2**252)
    O = algebra(37).extremal_order()
    I = O.random_ideal(5, seed=2)
    norms = {int(x.norm() / 5) for x in I.elements_of_norm_at_most(5 * 30)} - {0}
    for total in range(1, 30):
        if any(total - n in norms and math.gcd(n, total) == 1 for n in norms):
            check_pair(I, total)
        else:
            with pytest.raises(NoEquivalentIdealError):
                I.equivalent_pair(total)


@pytest.mark.parametrize("p", [2**61 - 1, 10**9 + 9, 10**9 + 21, P])
def test_the_steps_of_klpt(p) -> None:
    """10⁹ + 9 ≡ 1 modulo 8, 10⁹ + 21 ≡ 5 modulo 8."""
    O = algebra(p).extremal_order()
    n = 1013
    for seed in range(3):
        I = O.random_ideal(n, seed=seed)
        gamma = O.represent_integer(n * 3 ** (p.bit_length() + 20), seed=seed)
        mu0 = I.ideal_mod_constraint(gamma)
        assert mu0 in O
        assert gamma * mu0 in I
        mu = O.strong_approximation(mu0, n, 6**600, seed=seed)
        assert gamma * mu in I
        assert 6**600 % mu.norm() == 0
        ratio = [x for x in range(n) if (mu - x * mu0) / n in O]
        assert len(ratio) == 1
        delta = O.represent_integer(p * 2**40, seed=seed)
        between = O & I.right_order()
        assert gamma * I.eichler_mod_constraint(gamma, delta) * delta in between
        assert delta * I.eichler_mod_constraint(delta) in between


def test_strong_approximation_is_decided_for_small_numbers() -> None:
    rng, answers = Random(3), set[bool]()
    for _ in range(12):
        p, n = rng.choice([31, 43, 67]), rng.choice([3, 5])
        O = algebra(p).extremal_order()
        x = O.random_ideal(n, seed=1).ideal_mod_constraint(
            O.represent_integer(n * (20 * p + rng.randrange(p)))
        )
        if x.norm() % n == 0:
            continue
        number = 12 * rng.randrange(1, 40)
        divisors = [d for d in range(1, number + 1) if number % d == 0 and d % n]
        all_of_them = (y for d in divisors for y in O.elements_of_norm(d))
        fits = any((y - k * x) / n in O for y in all_of_them for k in range(1, n))
        answers.add(fits)
        if fits:
            mu = O.strong_approximation(x, n, number)
            assert number % mu.norm() == 0
            assert any((mu - k * x) / n in O for k in range(1, n))
        else:
            with pytest.raises(NoSolutionError, match="all its divisors"):
                O.strong_approximation(x, n, number)
    assert answers == {True, False}


def test_what_is_refused_with_the_reason() -> None:
    O = algebra(1019).extremal_order()
    I = O.random_ideal(101, seed=1)
    eichler = algebra(1019).eichler_order(3).random_ideal(101, seed=1)
    indefinite = QuaternionAlgebra(6).maximal_order().random_ideal(5, seed=1)
    other = algebra(P).extremal_order().random_ideal(2**89 - 1, seed=1).right_order()
    gamma = O.represent_integer(101 * 2**40)
    for error, message, call in [
        (LatticeError, "level 3", lambda: eichler.equivalent_of_norm_dividing(2**200)),
        (LatticeError, "level 3", lambda: eichler.equivalent_pair(2**200)),
        (IndefiniteError, "indefinite", lambda: indefinite.equivalent_of_norm_dividing(2**200)),
        (IndefiniteError, "indefinite", lambda: indefinite.equivalent_pair(2**200)),
        (LatticeError, "positive integer", lambda: I.equivalent_of_norm_dividing(0)),
        (LatticeError, "positive integer", lambda: I.equivalent_of_norm_dividing(2.5)),
        (LatticeError, "positive integer", lambda: I.equivalent_pair(-4)),
        (LatticeError, "prime norm", lambda: O.random_ideal(15).ideal_mod_constraint(1)),
        (LatticeError, "integral ideals", lambda: (I / 3).ideal_mod_constraint(1)),
        (LatticeError, "does not lie", lambda: I.ideal_mod_constraint(gamma / 3)),
        (LatticeError, "does not lie", lambda: I.eichler_mod_constraint(gamma, gamma / 3)),
        (LatticeError, "no element", lambda: I.ideal_mod_constraint(1)),
        (LatticeError, "left ideals", lambda: I.conjugate().ideal_mod_constraint(gamma)),
        (LatticeError, "p-extremal", lambda: other.random_ideal(101).ideal_mod_constraint(1)),
        (LatticeError, "odd prime", lambda: O.strong_approximation(1, 15, 2**99)),
        (LatticeError, "odd prime", lambda: O.strong_approximation(1, 2, 3**99)),
        (LatticeError, "modulo 101·O", lambda: O.strong_approximation(1, 101, 2**99)),
    ]:
        with pytest.raises(error, match=message):
            call()
    with pytest.raises(UndecidedError, match=r"about \d+ bits is needed"):
        O.strong_approximation(I.ideal_mod_constraint(gamma), 101, 2**20)
    with pytest.raises(UndecidedError, match=r"about \d+ bits is needed"):
        algebra(P).extremal_order().random_ideal(101, seed=1).equivalent_of_norm_dividing(2**300)


def test_divisors_come_in_order_and_close_to_the_bound() -> None:
    D = Divisors(((2, 3), (3, 2), (5, 1)))
    assert [*D.ascending()] == [n for n in range(1, 361) if 360 % n == 0]
    rng = Random(1)
    for least in range(1, 361):
        found = [*D.above(least, rng)]
        assert all(n >= least and 360 % n == 0 for n in found)
        assert found[-1] == 360 or 360 in found
    assert D.without(12) == Divisors(((2, 1), (3, 1), (5, 1)))
    assert [*D.above(361, rng)] == [360]
    assert [*D.above(360 * 64 + 64, rng)] == []
