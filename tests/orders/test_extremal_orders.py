"""Maximal orders with anticommuting roots of −q and −p."""

import pytest

from hfield import QuaternionAlgebra
from hfield.errors import LatticeError


def roots(order, n):
    """Return the elements of trace 0 and norm n."""
    return [x for x in order.elements_of_norm(n) if not x.trace()]


def contains_roots(order, q, p, half):
    """Tell whether an order has anticommuting roots x of −q and y of −p, and (1 + x)/2 or (1 + y)/2."""
    return any(
        x * y == -(y * x) and (half is None or (1 + (x, y)[half]) / 2 in order)
        for x in roots(order, q)
        for y in roots(order, p)
    )


@pytest.mark.parametrize(
    ("p", "q"), [(47, 3), (47, 17), (41, 3), (41, 7), (29, 11), (53, 2), (47, 2), (47, 1), (23, 23)]
)
def test_the_class_of_an_extremal_order_among_all_maximal_orders(p, q) -> None:
    A = QuaternionAlgebra(p)
    classes = A.maximal_order().class_set()
    types = dict(zip(classes.types, classes.left_orders(), strict=True)).values()
    half = None if q == 2 and p % 4 == 1 else 1 if p % 4 == 3 else 0
    fitting = [O for O in types if contains_roots(O, q, p, half)]
    assert len(fitting) == 1
    assert A.extremal_order(q).is_isomorphic(fitting[0])
    both = [O for O in types if contains_roots(O, q, p, None)]
    assert len(both) == (2 if q % 2 and q not in (1, p) else 1)


@pytest.mark.parametrize(("p", "q"), [(419, 1), (5, 2), (13, 2), (17, 3), (73, 7), (2, 1)])
def test_the_default_is_a_named_one(p, q) -> None:
    A = QuaternionAlgebra(p)
    assert A.extremal_order() == A.extremal_order(q)


def test_the_orders_of_sqisign() -> None:
    """The q of SQIsign 2.0.1, level 1, and the basis that its scripts write for q = 5."""
    p = 5 * 2**248 - 1
    A = QuaternionAlgebra("QQ", -5, -p)
    r = next(r for r in range(20) if (r * r + p) % 20 == 0)
    O = A.order_from_basis(["1", "i", "1/2 + 1/2*j", f"{r}/10*i - 1/10*k"])
    assert A.extremal_order(5).is_isomorphic(O)
    B = QuaternionAlgebra("QQ", -1, -p)
    start = B.extremal_order()
    for q in (5, 17, 37, 41, 53, 97):
        E = B.extremal_order(q)
        assert E.is_maximal()
        K = start.connecting_ideal(E)
        assert K.left_order() == start
        assert K.right_order() == E
        assert not E.is_isomorphic(start)


@pytest.mark.parametrize(
    ("p", "q", "reason"),
    [
        (11, 12, "square factor 2²"),
        (11, 14, "−11 is not a square modulo 7"),
        (13, 3, "a square modulo 13"),
        (13, 1, "a square modulo 13"),
        (11, 0, "positive integer"),
        (11, -5, "positive integer"),
        (11, "two", "positive integer"),
    ],
)
def test_what_does_not_fit_is_refused_with_the_reason(p, q, reason) -> None:
    with pytest.raises(LatticeError, match=reason):
        QuaternionAlgebra(p).extremal_order(q)
