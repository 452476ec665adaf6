"""The checker over completions: what the place shows, and nothing that only the global field knows."""

from random import Random

import pytest

from hfield import QuaternionAlgebra, prove, ring
from hfield.certificates.anisotropy import is_certified
from hfield.certificates.check import check
from hfield.certificates.rejection import Rejected
from hfield.certificates.scalars.fields import read_field
from hfield.structure import norm_evidence, zero_norm

FIELDS = (
    "Qp(2)", "Qp(3)", "Qp(5)", "QQ(sqrt(2))_(2)", "QQ(sqrt(2))_(3)", "QQ(I)_(5, I-2)", "QQ(sqrt(5))_(2)",
    "QQ(sqrt(-7))_(2, sqrt(-7)-1)", "GF(3)((t))", "GF(2)((t))", "GF(9)((t))", "GF(2)(t)_(t^2+t+1)",
    "GF(4)(t)_inf", "QQ[s]/(s^3-2)_(2, s)", "QQ[s]/(s^3-2)_(7)",
)  # fmt: skip


@pytest.mark.parametrize("name", FIELDS)
def test_every_division_algebra_is_certified_and_no_split_one(name):
    F, rng, seen = ring(name), Random(3), set()
    t = int(F.characteristic == 2)
    for n in range(60):
        if n > 9 and len(seen) == 2:
            break
        a, b = (F.random(rng) * F.uniformiser ** rng.randint(0, 1) for _ in range(2))
        if F.is_zero(b) or F.is_zero(t * t + 4 * a):
            continue
        A = QuaternionAlgebra(F, a, b, t)
        answer = zero_norm(F, A.constants)
        seen.add(answer.element is None)
        data = norm_evidence(A.name, F, A.constants, answer) if answer.element is None else None
        assert (data is not None) == A.is_division_algebra(), A
        if data is not None:
            assert data["by"] == "place"
            assert not is_certified(A.name, name, {**data, "j": data["u"]})
            assert not is_certified(A.name, name, {**data, "place": "11"})
    assert seen == {True, False}


@pytest.mark.parametrize("by", ["ordering", "level"])
def test_what_holds_over_the_global_field_alone_is_not_used(by):
    assert is_certified("(-1,-1|QQ)", "QQ", {"by": by})
    assert not is_certified("(-1,-1|Qp(5))", "Qp(5)", {"by": by})
    assert not is_certified(
        "(-1,-1|QQ(sqrt(2))_(7,sqrt(2)-3))", "QQ(sqrt(2))_(7,sqrt(2)-3)", {"by": by}
    )


@pytest.mark.parametrize(
    "name",
    [
        "Qp(1)", "Qp(4)", "Qp(15)", "Qp(x)", "QQ(sqrt(2))_(7)", "QQ(sqrt(2))_(15)", "QQ(sqrt(17))_(2)",
        "QQ(sqrt(2))_(7,sqrt(2)-5)", "QQ(sqrt(2))_(21,sqrt(2)-3)", "GF(3)(t)_(t^2-1)", "QQ(x)_(x)", "QQ((x))",
        "ZZ_(5)", "RR_(5)", "QQ[s]/(s^3-2)_(5)", "QQ[s]/(s^3-2)_inf1", "QQ[s]/(s^3-2)_inf-", "QQ(I)_inf-",
        "QQ(sqrt(2))_inf0", "QQ_inf0", "QQ(zeta5)_inf0",
    ],
)  # fmt: skip
def test_what_is_no_completion_is_refused(name):
    with pytest.raises(Rejected):
        read_field(name)


@pytest.mark.parametrize(
    ("name", "negative", "positive"),
    [
        ("QQ(sqrt(2))_inf-", "1+sqrt(2)", "1-sqrt(2)"),
        ("QQ[s]/(s^3-2)_inf0", "s-2", "s-1"),
        ("QQ(root(2,4))_inf0", "root(2,4)", "-root(2,4)"),
        ("QQ(root(2,4))_inf1", "-root(2,4)", "root(2,4)"),
        ("QQ(zeta7)+_inf1", "c7", "c7+1"),
    ],
)
def test_at_a_real_place_the_one_ordering_is_used(name, negative, positive):
    by = {"by": "ordering"}
    assert is_certified(f"({negative},-1|{name})", name, by)
    assert not is_certified(f"({positive},-1|{name})", name, by)
    assert QuaternionAlgebra(name, negative, -1).is_division_algebra()
    assert not QuaternionAlgebra(name, positive, -1).is_division_algebra()
    assert read_field(name).level_above(100)
    assert not read_field(name).is_square(read_field(name).read(negative))
    assert prove("norm(q) == 0 => q == 0", algebra=f"({negative},-1|{name})").certificate


def test_elements_with_an_o_mean_nothing_to_the_checker():
    with pytest.raises(Rejected):
        read_field("Qp(5)").read("2+O(5^4)")
    assert prove("norm(q) == 0 => q == 0", algebra="(2+O(5),5|Qp(5))").certificate is None


@pytest.mark.parametrize(
    ("statement", "algebra"),
    [
        ("norm(q) == 0 => q == 0", "(2,5|Qp(5))"),
        ("p*q == 0 => p == 0 or q == 0", "H(Qp(2))"),
        ("norm(q) == 0 => q == 0", "[1,t|GF(2)((t)))"),
        ("p*q == q*p", "(2,5|Qp(5))"),
        ("exists s: s*s == 2", "(2,5|Qp(5))"),
        ("exists s: s*s == 5", "(2,5|Qp(5))"),
        ("norm(q) == 0 => q == 0", "(1,5|Qp(5))"),
    ],
)
def test_verdicts_have_certificates(statement, algebra):
    decision = prove(statement, algebra=algebra)
    assert decision.verdict in ("proved", "refuted")
    assert decision.certificate is not None


def test_squares_are_refused_only_where_they_are_none():
    for name, p in (("Qp(5)", 5), ("Qp(7)", 7)):
        F, field = read_field(name), ring(name)
        for n in range(1, 60):
            try:
                assert not F.is_square(F.number(n))
            except Rejected:
                continue
            assert not field.is_square(field(n)), (p, n)


REFUTED = ("norm(q) == 0 => q == 0", "(-1,-1|Qp(7))")
FOUND = ("exists s: s*s == -7", "(-1,-1|Qp(2))")


@pytest.mark.parametrize(("statement", "algebra"), [REFUTED, FOUND])
def test_a_witness_in_a_subfield_with_a_root_that_hensel_lifts(statement, algebra):
    data = prove(statement, algebra=algebra).certificate
    assert data["evidence"]["kind"] == "subfield"
    assert check(data).field == ring(data["field"]).name


@pytest.mark.parametrize(
    ("changes", "why"),
    [
        ({"root": "0"}, "not so near"),
        ({"root": "3"}, "not so near"),
        ({"root": "1/7"}, "without 7 in a denominator"),
        ({"root": "x"}, "no element"),
        ({"field": "QQ(sqrt(-1))"}, None),
        ({"field": "QQ"}, "no number field"),
        ({"field": "QQ(sqrt(-5))"}, None),
        ({"witness": {"kind": "identity"}}, None),
    ],
)
def test_a_changed_subfield_is_none(changes, why):
    data = prove(REFUTED[0], algebra=REFUTED[1]).certificate
    forged = {**data, "evidence": {**data["evidence"], **changes}}
    with pytest.raises(Rejected, match=why):
        check(forged)


def test_no_subfield_of_another_field_and_no_root_that_is_none():
    data = prove("exists s: s*s == -7", algebra="(-1,-1|Qp(2))").certificate
    for field in ("Qp(3)", "Qp(5)", "QQ(I)_(2)", "QQ"):
        with pytest.raises(Rejected):
            check({**data, "field": field, "algebra": f"(-1,-1|{field})"})
    for root, near in (
        ("1", True),
        ("3", True),
        ("5/3", True),
        ("2", False),
        ("4", False),
        ("1/2", False),
    ):
        forged = {**data, "evidence": {**data["evidence"], "root": root}}
        if near:  # r² + 7 is divisible by 8 = 2^(2·v(2r) + 1)
            assert check(forged)
        else:
            with pytest.raises(Rejected, match="Hensel"):
                check(forged)
