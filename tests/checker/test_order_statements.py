"""Statements about orders, ideals and embeddings, one by one: what is accepted and why others are not."""

import pytest

from hfield import QuaternionAlgebra
from tests.checker.cases import about_field
from tests.checker.order_certificates import (
    HURWITZ,
    LIPSCHITZ,
    TWICE,
    about,
    established,
    order,
    rejects,
)


def test_too_large_an_ideal_is_not_locally_principal() -> None:
    O = QuaternionAlgebra("QQ", -1, -11).order(["2*i", "2*j"])
    I = O.right_ideal([2, "i + j"])  # an ideal, but of no class
    assert not I.is_invertible()
    assert I.certificate is None
    assert "not locally principal" in str(I.claim.why_no_certificate)


def test_orders() -> None:
    assert established(order(LIPSCHITZ, 4))
    assert established(order(HURWITZ, 2, more="; maximal"))
    rejects(order(LIPSCHITZ, 4, more="; maximal"), "not shown that this order is maximal at 2")
    rejects(order(HURWITZ, 4), "another reduced discriminant")
    rejects(order(HURWITZ, 2, more="; minimal"), "nothing more")
    rejects(order(HURWITZ, 2, more="; maximal; maximal"), "parts")
    rejects(order("1,0,0,0 | 0,1,0,0 | 0,0,1,0 | 0,0,0,1/2", 2), "a product of two rows")
    rejects(order("2,0,0,0 | 0,2,0,0 | 0,0,2,0 | 0,0,0,2", 64), "1 is not in it")
    rejects(order("1,0,0,0 | 0,1,0,0 | 0,0,1,0 | 0,1,1,0", 4), "rank below 4")
    rejects(order("1,0,0,0 | 0,1,0,0 | 0,0,1,0", 4), "four rows")
    rejects(order("1,0,0,0 | 0,1,0,0 | 0,0,1,0 | 0,0,0,1/0", 4), "divides by 0")
    rejects(order("1,0,0,0 | 0,1,0,0 | 0,0,1,0 | 0,0,0,e", 4), "no rational number")
    rejects(order(LIPSCHITZ, 4, "(-1,0|QQ)"), "degenerate")
    rejects(order(LIPSCHITZ, 4, "(-1,a|QQ)"), "numbers for constants")
    for field in (None, "GF(5)"):
        rejects(about_field(order(LIPSCHITZ, 4), field), "over QQ alone")
    rejects({**order(LIPSCHITZ, 4), "verdict": "refuted"}, "does not show")
    rejects({**order(LIPSCHITZ, 4), "evidence": {"kind": "order", "n": 4}}, "unknown key")
    huge = "9" * 4001
    rejects(order(f"1,0,0,0 | 0,{huge},0,0 | 0,0,1,0 | 0,0,0,1", 4), "no rational number")
    big = f"1,0,0,0 | 0,1{'0' * 3000},0,0 | 0,0,1{'0' * 3000},0 | 0,0,0,1{'0' * 3900}"
    rejects(order(big, 4, more="; maximal"))


def test_an_eichler_order_is_not_maximal() -> None:
    """At a prime that divides the discriminant once the Eichler symbol decides."""
    A = QuaternionAlgebra("QQ", -1, -11)
    data = A.eichler_order(3).certificate
    assert data is not None
    assert data["statement"].endswith("; 33}")
    rejects({**data, "statement": data["statement"][:-1] + "; maximal}"}, "maximal at 3")
    # ℤ[i] + 3·O has the symbol −1 at 3, as a maximal order of a division algebra has
    O = A.maximal_order()
    smaller = A.order(["i", *(3 * q for q in O.basis)])
    assert smaller.eichler_symbol(3) == -1
    data = smaller.certificate
    assert data is not None
    rejects({**data, "statement": data["statement"][:-1] + "; maximal}"}, "maximal at 3")


@pytest.mark.slow
def test_what_both_orders_have_tells_nothing() -> None:
    O = QuaternionAlgebra("QQ", -1, -11).maximal_order()
    data = O.isomorphism(O.ideals_of_norm(2)[0].right_order()).certificate
    assert data is not None
    for changes in ({"norm": 10**3, "trace": 7}, {"norm": -1}):
        rejects(
            {**data, "evidence": {**data["evidence"], **changes}}, "both orders have 0 elements"
        )


def test_optimal_embeddings() -> None:
    """2·i has the discriminant −16, but i is in the order."""
    data = QuaternionAlgebra("QQ", -1, -11).maximal_order().embeddings(-4).certificate
    assert data is not None
    assert established(data)
    twice = {"kind": "embedding", "element": ["0", "2", "0", "0"]}
    forged = {**data, "statement": data["statement"].replace("; -4}", "; -16}"), "evidence": twice}
    rejects(forged, "does not generate all integral elements")


def test_enumerations_that_are_not_exhausted() -> None:
    O = QuaternionAlgebra("QQ", -1, -11).maximal_order()
    I = O.ideals_of_norm(2)[0]
    data = I.is_principal().certificate
    assert data is not None
    rows = data["evidence"]["between"]
    thinner = {"den": rows["den"], "rows": [[3 * x for x in rows["rows"][0]], *rows["rows"][1:]]}
    rejects({**data, "evidence": {"kind": "equivalent", "between": thinner}}, "no basis of the")
    rejects({**data, "evidence": {"kind": "equivalent"}}, "need a basis")
    true = I.equivalence(I * O.algebra(1, 1, 0, 0)).certificate
    assert true is not None
    c = true["statement"]
    rejects({**data, "statement": c}, ".")
    between = I.inverse() * (I * O.algebra(1, 1, 0, 0))
    rows = {"den": between.hnf[0], "rows": [list(row) for row in between.hnf[1]]}
    forged = {**data, "statement": c, "evidence": {"kind": "equivalent", "between": rows}}
    rejects(forged, "an element carries")
    # in an indefinite algebra nothing is exhausted
    M = QuaternionAlgebra("QQ", 1, 5).maximal_order()
    N = M.ideals_of_norm(7)[0]
    certificate = N.is_principal().certificate
    assert certificate is not None
    for evidence in ({"kind": "equivalent"}, {"kind": "equivalent", "between": rows}):
        rejects(
            {**certificate, "verdict": "refuted", "evidence": evidence, "method": "enumeration"}
        )


def test_a_bad_basis_costs_work_and_not_truth() -> None:
    O = QuaternionAlgebra("QQ", -1, -11).maximal_order()
    data = O.ideals_of_norm(2)[0].is_principal().certificate
    assert data is not None
    rows = data["evidence"]["between"]["rows"]
    skew = [
        rows[0],
        *([x + 10**9 * y for x, y in zip(row, rows[0], strict=True)] for row in rows[1:]),
    ]
    between = {"den": data["evidence"]["between"]["den"], "rows": skew}
    skewed = {**data, "evidence": {"kind": "equivalent", "between": between}}
    assert established(skewed).verdict == "refuted"


def test_lattices_whose_volumes_are_not_like_those_of_ideals() -> None:
    refuted = {"verdict": "refuted", "method": "norm"}
    for side in ("left", "right"):
        statement = f"equivalent{{{side}; {LIPSCHITZ}; {TWICE}}}"
        assert established(about(statement, {}, **refuted)).scope == "field"
        basis = {
            "between": {"den": 1, "rows": [[2, 0, 0, 0], [0, 2, 0, 0], [0, 0, 2, 0], [0, 0, 0, 2]]}
        }
        rejects(about(statement, basis, **refuted), "there is nothing to run through")
    rejects(
        about(f"equivalent{{up; {LIPSCHITZ}; {TWICE}}}", {}, **refuted), "must be left or right"
    )
    same = f"equivalent{{left; {LIPSCHITZ}; {LIPSCHITZ}}}"
    rejects(about(same, {}, **refuted), "need a basis")


def test_statements_that_are_not_well_made() -> None:
    assert established(about(f"order{{{LIPSCHITZ}; 4}}", {}))
    for statement, said in (
        (f"order{{{LIPSCHITZ}; 4; maximal}}", "not shown that this order is maximal at 2"),
        (f"order{{{LIPSCHITZ}; 4; best}}", "maximal, or nothing more"),
        (f"order{{{LIPSCHITZ}; 9/2}}", "a discriminant must be an integer"),
        (f"order{{{LIPSCHITZ}; 2}}", "another reduced discriminant"),
        (f"order{{{LIPSCHITZ}; -4}}", "another reduced discriminant"),
        (f"order{{{TWICE}; 8}}", "1 is not in it"),
        (f"order{{{LIPSCHITZ.replace('1', '1/2', 1)}; 2}}", "a product of two rows is not in it"),
        (f"order{{{LIPSCHITZ.replace('1', '0', 1)}; 4}}", "of rank below 4"),
        (f"order{{{LIPSCHITZ[:-2]}; 4}}", "is no rational number|four rows"),
        (f"order{{{LIPSCHITZ}}}", "has not 1 parts"),
        (f"order{{{LIPSCHITZ.replace('1', '1/0', 1)}; 4}}", "divides by 0"),
    ):
        rejects(about(statement, {}), said)
