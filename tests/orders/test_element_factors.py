"""Factors of elements of prime norms, in all orders of the primes, multiplied out."""

import random
from functools import reduce
from itertools import permutations
from operator import mul
from typing import Any

import pytest

from hfield import H, LatticeError, QuaternionAlgebra
from hfield.core.factorisation import factorise


def multiplied(u: Any, factors: list[Any]) -> Any:
    return reduce(mul, factors, u)


def is_unit(O: Any, u: Any) -> bool:
    return u in O and u.inverse() in O


def test_hurwitz_quaternions_in_every_order_of_the_primes() -> None:
    rng, O = random.Random(1), H("QQ").hurwitz_order()
    for _ in range(4):
        x = O.algebra(*(rng.randint(-9, 9) for _ in range(3)), 1)
        primes = [p for p, e in factorise(int(x.norm())).items() for _ in range(e)]
        for chosen in list(permutations(primes))[:4]:
            u, factors = O.factor(x, chosen)
            assert multiplied(u, factors) == x
            assert is_unit(O, u)
            assert [q.norm() for q in factors] == list(chosen)
            assert all(q in O for q in factors)


def test_factors_of_a_primitive_element_are_unique_up_to_units_between_them() -> None:
    O = H("QQ").hurwitz_order()
    x = O.algebra("(1 + 2*i)*(1 + 2*j)*(2 + 3*k)")
    primes = [5, 5, 13]
    u, factors = O.factor(x, primes)
    for v in O.units():
        w, others = O.factor(v * x, primes)
        for n in range(3):
            first, second = multiplied(u, factors[: n + 1]), multiplied(w, others[: n + 1])
            assert is_unit(O, (v * first).inverse() * second)


@pytest.mark.parametrize(
    ("field", "primes"),
    [
        ("QQ(sqrt(2))", ["2 + sqrt(2)", "5 + 2*sqrt(2)", "5 - 2*sqrt(2)", 3]),
        ("QQ(sqrt(5))", [2, 3, "4 + sqrt(5)", "5/2 + 1/2*sqrt(5)"]),
        ("QQ[s]/(s^3+s^2-2*s-1)", [2]),
    ],
)
def test_over_number_fields(field: str, primes: list[Any]) -> None:
    A = H(field)
    O, K = A.maximal_order(), A.ring
    rng = random.Random(2)
    for _ in range(2):
        wanted = [rng.choice(primes) for _ in range(4)]
        chosen = [rng.choice(O.ideals_of_norm(K.ideal(p))).is_principal() for p in wanted]
        x = reduce(mul, [answer.element for answer in chosen])
        rng.shuffle(wanted)
        u, factors = O.factor(x, wanted)
        assert multiplied(u, factors) == x
        assert is_unit(O, u)
        assert [K.ideal(q.norm()) for q in factors] == [K.ideal(p) for p in wanted]
        assert [q.norm() for q in factors] == [K(p) for p in wanted]
    P = K.primes_above(2)[0]
    assert O.factor(1, []) == (A(1), [])
    if len(O.ideals_of_norm(P)) > 1:
        u, (pi, rho) = O.factor(P.generators[-1], [P, str(P)])
        assert u * pi * rho == P.generators[-1]


def test_where_several_ideals_contain_an_element_all_are_tried() -> None:
    O = QuaternionAlgebra(11).maximal_order()  # of two classes
    principal = [bool(I.is_principal()) for I in O.ideals_of_norm(2)]
    assert not all(principal)
    u, factors = O.factor(2, [2, 2])
    assert multiplied(u, factors) == 2
    # those of norm 3 in x·O are not principal, but those of 2 in the other order are
    x = O.algebra("i + j")
    with pytest.raises(
        LatticeError, match="norm 3 that contains i \\+ j, for factor 3, is not principal"
    ):
        O.factor(x, [2, 2, 3])
    E = O.algebra.eichler_order(3)  # at the level, more than one ideal contains an element
    for I in E.ideals_of_norm(9):
        found = I.is_principal()
        if found:
            try:
                u, factors = E.factor(found.element, [3, 3])
            except LatticeError:
                assert not any(J.is_principal() and found.element in J for J in E.ideals_of_norm(3))
            else:
                assert multiplied(u, factors) == found.element


@pytest.mark.parametrize(
    ("x", "primes", "words"),
    [
        (1, [3], "the norm 1 of 1 does not generate the product 3"),
        ("1 + i", [3], "does not generate"),
        ("1/3", [], "does not lie in the order"),
        (0, [2], "the norm 0 of 0"),
        (2, [4], "not a prime number"),
        (2, 2, "not a list of elements"),
    ],
)
def test_what_is_not_factored(x: Any, primes: Any, words: str) -> None:
    with pytest.raises(LatticeError, match=words):
        QuaternionAlgebra(11).maximal_order().factor(x, primes)


def test_in_an_indefinite_algebra() -> None:
    O = QuaternionAlgebra(6).maximal_order()
    x = O.basis[0] + 3 * O.basis[1] + 5 * O.basis[2] + 7 * O.basis[3]
    assert x.norm() == -89
    u, factors = O.factor(7 * x, [7, 89, 7])
    assert multiplied(u, factors) == 7 * x
    assert [abs(q.norm()) for q in factors] == [7, 89, 7]
    assert is_unit(O, u)


def test_the_valuation_counts_gates_t() -> None:
    """Operators with n gates T, by a search in breadth, are 72·2^(n−1), and n is the valuation at √2."""
    A = H("QQ(sqrt(2))")
    O, P = A.maximal_order(), A.ring.primes_above(2)[0]
    T, S, hadamard = A("1 + (1+k)/sqrt(2)"), A("(1+k)/sqrt(2)"), A("(i+k)/sqrt(2)")

    def projective(x: Any) -> Any:
        return x / next(c for c in x.coordinates if c != 0)

    cliffords = {projective(A.one): A.one}
    todo = [A.one]
    for x in todo:
        for y in (x * S, x * hadamard):
            if projective(y) not in cliffords:
                cliffords[projective(y)] = y
                todo.append(y)
    assert len(cliffords) == O.unit_index() == 24
    known, layer = set(cliffords), todo
    for n in (1, 2):
        found = {projective(x * T * c): x * T * c for x in layer for c in todo}
        layer = [x for key, x in found.items() if key not in known]
        known |= set(found)
        assert len(layer) == 72 * 2 ** (n - 1)
        for x in layer[::17]:
            while x / A.ring.gen in O:
                x /= A.ring.gen
            assert P.valuation(x.norm()) == n
            u, factors = O.factor(x, [P] * n)
            assert multiplied(u, factors) == x
