"""Orders of units: roots of unity of every kind found, infinite orders proved, the rest undecided."""

import itertools
import random

import pytest

from hfield import H, QuaternionAlgebra
from hfield.algebra.structure.elements.torsion import multiplicative_order
from hfield.core.product import multiply
from hfield.errors import NotInvertibleError, UndecidedError
from hfield.fields.names import ring
from tests.fields.algebra_cases import constants
from tests.subcases import subcases
from tests.thorough import quick_part


def order_of(algebra, text):
    return QuaternionAlgebra.from_text(algebra).parse(text).order()


@subcases(
    ("algebra", "text", "order"),
    [
        ("H(RR)", "1", 1),
        ("H(RR)", "-1", 2),
        ("H(RR)", "2", None),
        ("H(RR)", "2*i", None),
        ("H(RR)", "1+i+j+k", None),
        ("H(RR)", "(1+i+j+k)/2", 6),
        ("H(RR)", "3/5+4/5*i", None),
        ("H(RR)", "(sqrt(2)+sqrt(2)*i)/2", 8),
        ("H(RR)", "1/3+2*sqrt(2)/3*j", None),
        ("H(RR)", "cos(2*pi/7)+sin(2*pi/7)*i", 7),
        ("H(RR)", "cos(2*pi/97)+sin(2*pi/97)*(i+2*j+2*k)/3", 97),
        ("H(RR)", "cos(pi/240)+sin(pi/240)*i", 480),
        ("H(RR)", "root(2,5)/2+sqrt(1-root(4,5)/4)*k", None),
        ("H(RR)", "(sqrt(5)-1)/4+sqrt(10+2*sqrt(5))/4*k", 5),
        ("H(RR)", "pi", None),
        ("H(RR)", "1+pi*i", None),
        ("(pi,-1|RR)", "1+i", None),
        ("(pi,-1|RR)", "i/sqrt(pi)", 2),
        ("(pi,-1|RR)", "j", 4),
        ("(pi,-1|RR)", "sqrt(1+pi)+i", None),
        ("(1,1|RR)", "2*i+sqrt(3)*k", 2),
        ("(1,1|RR)", "1+i+k", None),  # the eigenvalue 1 twice: unipotent
        ("(1,1|RR)", "3/2+i/2+sqrt(3)/2*j", None),
        ("H(CC)", "I*i", 2),
        ("H(CC)", "I", 4),
        ("H(CC)", "2*I", None),
        ("H(CC)", "exp(I*pi/7)*j", 28),
        ("H(CC)", "cos(pi/5)+I*sin(pi/5)", 10),
        ("H(CC)", "exp(2*I*pi/3)*(1+i)/sqrt(2)", 24),
        ("H(CC)", "(1+I)/2+(1+I)/2*i", 4),
        ("H(CC)", "I*sqrt(2)+sqrt(3)*i", None),
        ("H(QQ)", "(1+i+j+k)/2", 6),
        ("H(ZZ)", "-i", 4),
        ("H(QQ(x))", "i", 4),
        ("H(QQ(x))", "x", None),
        ("(x,1|QQ[x,y])", "j", 2),
        ("(x,1|GF(3)[x])", "(2*x+1)+i+2*x*j", None),
        ("(2*x,1|GF(3)[x])", "1+i+k", 3),
        ("(x,1|GF(3)[x])", "2*j", 2),
        ("(t,1|GF(9)(t))", "x", 8),
        ("(t,1|GF(9)(t))", "1+i", None),
    ],
)  # fmt: skip
def test_orders(algebra, text, order):
    assert order_of(algebra, text) == order


@pytest.mark.parametrize("algebra", ["H(RR)", "H(CC)"])
def test_every_cosine_has_its_order(algebra):
    for n in quick_part((*range(1, 25), 30, 31, 36)):
        for m in (1, n // 2 - 1):
            if m > 0 and all(m % p or n % p for p in (2, 3, 5, 7, 11, 13)):
                assert order_of(algebra, f"cos({2 * m}*pi/{n})+sin({2 * m}*pi/{n})*k") == n


def test_near_to_a_root_of_unity_is_none():
    assert order_of("H(RR)", "(1-10^(-40))*(3/5+4/5*i)") is None
    # a Pythagorean triple whose angle is within 10^-30 of a right one
    m, n = 10**30 + 1, 10**30
    a, b = m * m - n * n, 2 * m * n
    assert order_of("H(RR)", f"{a}/{m * m + n * n}+{b}/{m * m + n * n}*i") is None


def test_transcendental_numbers_are_undecided():
    for algebra, text in (("H(RR)", "cos(1)+sin(1)*j"), ("H(CC)", "exp(I)"), ("H(CC)", "exp(I)*i")):
        with pytest.raises(UndecidedError, match="infinite or greater than 1000"):
            order_of(algebra, text)


@pytest.mark.parametrize("name", ["ZZ/4", "ZZ/6", "ZZ/9", "GF(4)", "GF(5)", "duals"])
def test_orders_over_finite_rings_by_multiplying(name, dual_numbers):
    R = dual_numbers(ring("GF(4)")) if name == "duals" else ring(name)
    everything = list(R.elements())
    rng = random.Random(1)
    one = (R.one, R.zero, R.zero, R.zero)
    key = lambda q: tuple(map(R.key, q))  # noqa: E731
    for _ in range(25):
        a, t, b = (rng.choice(everything) for _ in "atb")
        c = constants("ZZ", 0, 0, 0)._replace(a=a, t=t, b=b)
        q = tuple(rng.choice(everything) for _ in "wxyz")
        power, powers = q, {}
        for n in itertools.count(1):
            if key(power) in powers or key(power) == key(one):
                break
            powers[key(power)] = n
            power = multiply(c, power, q)
        if key(power) == key(one):
            assert multiplicative_order(R, c, q) == n
        else:
            with pytest.raises(NotInvertibleError):
                multiplicative_order(R, c, q)


@pytest.mark.parametrize("name", ["GF(2305843009213693951)", "GF(3^40)", "GF(2^61)", "ZZ/1000000"])
def test_orders_in_large_rings(name):
    A = H(name)
    for seed in range(3):
        q = A.random_element(seed)
        if not q.is_unit():
            continue
        n = q.order()
        assert q**n == 1
        for p in (2, 3, 5, 7, 11, 13, 31, 41):
            assert n % p or q ** (n // p) != 1


def test_a_users_ring_that_is_infinite(dual_numbers):
    A = H(dual_numbers(ring("QQ")))
    assert A("i + eps*k").order() is None or A("i + eps*k") ** 4 == 1
    assert A("i").order() == 4
    with pytest.raises(UndecidedError, match="infinite or greater than 120"):
        A("1 + eps*i").order()
    with pytest.raises(UndecidedError, match="inexact"):
        H("RDF")(0, 1, 0, 0).order()
