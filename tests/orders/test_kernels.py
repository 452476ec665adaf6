"""What is quicker over ℤ against the functions for any rank, on random lattices."""

from fractions import Fraction
from random import Random

from flint import fmpz, fmpz_mat

from hfield import QuaternionAlgebra
from hfield.orders import (
    generated_orders,
    hermite,
    lattice_values,
    maximal_orders,
    quadratic_orders,
    short_elements,
)
from hfield.orders.kernels import general, ideal_products, rank4
from hfield.orders.lattice_values import LatticeValue
from tests.orders.random_lattices import algebra


def random_lattice(rng: Random) -> LatticeValue:
    ambient = lattice_values.basis_of(algebra(rng))
    while True:
        rows = fmpz_mat([[rng.randint(-9, 9) for _ in range(4)] for _ in range(4)])
        if rows.rank() == 4:
            return lattice_values.hermite_form(ambient, rng.randint(1, 12), rows)


def test_maximal_orders_without_and_with_a_kernel() -> None:
    """They differ, and have the discriminant of the algebra."""
    rng = Random(2)
    for _ in range(20):
        ambient = lattice_values.basis_of(algebra(rng))
        orders = [
            maximal_orders.overorder(lattice_values.hermite_form(ambient, *kernel(ambient)))
            for kernel in (rank4.first_order, general.first_order)
        ]
        for order in orders:
            assert generated_orders.checked_ring(order) is order
            assert lattice_values.discriminant(order) == ambient.discriminant


def test_every_kernel_gives_what_the_general_function_gives() -> None:
    rng = Random(1)
    principal, definite = set(), 0
    for _ in range(60):
        L = random_lattice(rng)
        ambient = L.ambient
        given = (ambient, L.grams, L.content, L.den)
        assert rank4.norm(*given) == general.norm(*given)
        assert rank4.content(L.grams[0]) == general.content(L.grams[0])
        assert rank4.volume(ambient, L.matrix, L.den) == general.volume(ambient, L.matrix, L.den)
        other = lattice_values.conjugate(lattice_values.scaled(L, Fraction(2, 3)))
        assert rank4.index(L, other) == general.index(L, other) == Fraction(16, 81)
        for side in ("left", "right"):
            given = (L, ambient.norm_products(L.matrix, side))
            assert hermite.hermite(*rank4.order_rows(*given)) == hermite.hermite(
                *general.order_rows(*given)
            )
        order = lattice_values.colon(L, L, "left")
        element = L.basis[0] + 3 * L.basis[2] + 2
        left = lattice_values.generated_ideal(order, [element], "left")
        right = lattice_values.generated_ideal(order, [element, L.basis[1]], "right")
        given = (right, left, order)
        assert ideal_products.product(*given) == lattice_values.product(right, left)
        for ideal in (L, left):
            found = rank4.is_locally_principal(ideal, order)
            assert found == general.is_locally_principal(ideal, order)
            principal.add(found)
        x = [rng.randint(-9, 9) for _ in range(4)]
        columns = list(zip(*hermite.tuples(L.matrix), strict=True))
        assert rank4.combination(x, columns) == general.combination(x, columns)
        assert rank4.combination(x, columns) == hermite.combination(x, L.matrix)
        if ambient.definite:
            theta = (ambient, L.den, *L.reduced, L.content, L.norm, 12)
            assert rank4.theta_series(*theta) == general.theta_series(*theta)
            x = order.basis[0] + 2 * order.basis[1]
            rows = list(short_elements.rows_of_norm(order, ambient.base.inside(x.norm())))
            assert ambient.row(x) in rows or -ambient.row(x) in rows
            for row in rows:
                given = (ambient, order.den, (row * order.den).numer_denom()[0], x.norm())
                assert rank4.has_norm(*given) == general.has_norm(*given) is True
            definite += 1
            den, rows, gram = order.reduced_ternary
            theta = (ambient, den, rows, gram, fmpz(ambient.scale * den**2), Fraction(1), 12)
            assert rank4.theta_series(*theta) == general.theta_series(*theta)
    assert definite > 5
    assert principal == {True, False}
    names = {name for name in vars(rank4) if callable(getattr(rank4, name)) and name.islower()}
    own = {name for name in names if getattr(rank4, name).__module__ == rank4.__name__}
    assert {name for name in own if name[0] != "_"} <= set(vars(general))


def test_elements_of_large_norm_without_and_with_a_kernel() -> None:
    rng = Random(3)
    for d in (2, 11, 30, 101):
        order = QuaternionAlgebra(d).maximal_order().value
        for n in (d, 10**9 + 7, 15 * (10**12 + 39)):
            for kernel in (quadratic_orders.in_quadratic_orders, quadratic_orders.in_random_ideals):
                x = kernel(order, order.ambient.base.inside(n), rng)
                assert x is not None
                assert x.norm() == n
                assert lattice_values.contains(order, x)
