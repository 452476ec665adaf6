"""Ideals of Sage: products, orders, intersections, theta series, equivalence."""

import json
from pathlib import Path

from hfield import QuaternionAlgebra

CASES = json.loads((Path(__file__).parent.parent / "vectors" / "orders.json").read_text())["cases"]


def lattice(A, rows):
    return A.lattice([tuple(A.ring(x) for x in row) for row in rows])


def test_ideals_agree_with_sage() -> None:
    equivalent = 0
    for case in CASES:
        A = QuaternionAlgebra("QQ", case["a"], case["b"])
        assert A.discriminant() == case["discriminant"]
        O = A.order_from_basis(lattice(A, case["order"]).basis)
        assert O.is_maximal()
        assert A.order(O.basis) == O
        I, J = (O.left_ideal(lattice(A, case[name]).basis) for name in "IJ")
        assert I == lattice(A, case["I"])
        assert [str(I.norm()), str(J.norm())] == case["norms"]
        assert I.left_order() == O
        assert I.right_order() == lattice(A, case["right_order_I"])
        assert I.conjugate() * J == lattice(A, case["conj_I_J"])
        assert I & J == lattice(A, case["meet"])
        if "equivalent" in case:
            found = I.equivalence(J)
            assert bool(found) == case["equivalent"], case
            equivalent += case["equivalent"]
            assert not found or I * found.element == J
        if "theta" in case:
            assert I.theta_series(11) == case["theta"]
            assert O.unit_count() == case["units"]
    assert 5 < equivalent < len(CASES)
