"""Maximal orders over the integers of number fields: closure, discriminants, pseudo-bases, by definition."""

from itertools import product
from math import prod
from random import Random

import flint
import pytest

from hfield import QuaternionAlgebra, ring
from hfield.errors import HFieldError, LatticeError, RingError
from hfield.orders.lattice import Order
from tests.subcases import share_quick
from tests.thorough import quick_part

FIELDS = ["QQ[s]/(s^3-2)", "QQ(zeta5)", "QQ(zeta7)+", "QQ(sqrt(5))", "QQ(sqrt(-5))", "QQ[s]/(s^4+210*s^2+11)",
          "QQ[s]/(s^3-s^2-2*s-8)", "QQ(sqrt(2),sqrt(3))"]  # fmt: skip


def algebras(name: str) -> list[QuaternionAlgebra]:
    K, rng, out = ring(name), Random(name), [QuaternionAlgebra(name, -1, -1)]
    while len(out) < 4:
        a, b = K.random(rng), K.random(rng)
        t = len(out) % 2
        if not any(map(K.is_zero, (a, b, a * 4 + t))):
            out.append(QuaternionAlgebra(K, a, b, t))
    return out


@pytest.mark.parametrize("name", share_quick(FIELDS, 6))
def test_maximal_orders(name: str) -> None:
    """A ring of integral elements whose discriminant is the product of the ramified primes."""
    for A in algebras(name):
        O = A.maximal_order()
        assert isinstance(O, Order)
        assert O.is_maximal()
        ramified = [P for P in A.ramified_places() if P.is_finite]
        assert [P for P, e in O.discriminant().factorisation() if e == 1] == ramified
        assert O.discriminant().norm() == O.norm_of_discriminant()
        assert O.norm_of_discriminant() == prod(P.p**P.f for P in ramified)
        assert len(O.basis) == 4 * A.ring.degree
        assert 1 in O
        few = Random(1).sample(O.basis, 5)
        assert all(p * q in O for p, q in product(few, O.basis))
        for q in O.basis:
            for x in (q.norm(), q.trace()):
                assert all(c.q == 1 for c in _integral(A.ring, x))
            assert q * flint.fmpq(1, 7) not in O or q == 0


@pytest.mark.parametrize("name", share_quick(FIELDS, 2))
def test_pseudo_bases_span_the_order(name: str) -> None:
    for A in quick_part(algebras(name)[:3], 2):
        O = A.maximal_order()
        pairs = O.pseudo_basis()
        elements = [x * q for ideal, q in pairs for x in ideal]
        assert len(pairs) == 4
        assert all(q in O for q in elements)
        rows = flint.fmpq_mat([O.value.ambient.row(q).entries() for q in elements])
        assert abs(rows.det()) == abs(O.value.rows.det())


def test_what_has_no_maximal_order_here() -> None:
    with pytest.raises(RingError, match="degenerate"):
        QuaternionAlgebra("QQ(zeta5)", 0, 1).maximal_order()
    with pytest.raises(HFieldError):
        QuaternionAlgebra("QQ(x)", "x", 2).maximal_order()


def test_a_lattice_that_is_no_ring_is_caught() -> None:
    A = QuaternionAlgebra("QQ[s]/(s^3-2)", -1, -1)
    O = A.maximal_order()
    with pytest.raises(LatticeError, match="the product of"):
        A.order_from_basis([*O.basis[:-1], O.basis[-1] * flint.fmpq(1, 2)])
    with pytest.raises(LatticeError, match="1 is not in it"):
        A.order_from_basis([2 * q for q in O.basis])
    assert A.order_from_basis(O.basis) == A.order_from_basis(O.pseudo_basis()) == O


def _integral(K: object, x: object) -> list:
    if hasattr(x, "minimal_polynomial"):
        return x.minimal_polynomial()
    from hfield.fields.number_fields.quadratic.places import integer_coordinates

    return [flint.fmpq(c.numerator, c.denominator) for c in integer_coordinates(K.d, x)]
