"""The checker over completions: what the place shows, and nothing that only the global field knows."""

from random import Random

import pytest

from hfield import QuaternionAlgebra, prove, ring
from hfield.checker.anisotropy import is_certified as certifies
from hfield.checker.check import check
from hfield.checker.rejection import Rejected
from hfield.checker.scalars.fields import read_ring
from hfield.fields.quadratic_forms import norm_evidence, zero_norm
from tests.checker.cases import about_field
from tests.checker.ring_data import (
    CC,
    INFINITY,
    QQ,
    RR,
    ZZ,
    completion,
    cyclotomic,
    data_of,
    finite,
    functions,
    generated,
    ideal,
    multiquadratic,
    number,
    other,
    prime,
    quadratic,
    read_field,
    real,
    split,
)
from tests.subcases import subcases

FIELDS = (
    "Qp(2)", "Qp(3)", "Qp(5)", "QQ(sqrt(2))_(2)", "QQ(sqrt(2))_(3)", "QQ(I)_(5, I-2)", "QQ(sqrt(5))_(2)",
    "QQ(sqrt(-7))_(2, sqrt(-7)-1)", "GF(3)((t))", "GF(2)((t))", "GF(9)((t))", "GF(2)(t)_(t^2+t+1)",
    "GF(4)(t)_inf", "QQ[s]/(s^3-2)_(2, s)", "QQ[s]/(s^3-2)_(7)",
)  # fmt: skip


ROOT, CUBE = quadratic(2), generated([-2, 0, 0, 1])


def is_certified(algebra, name, reason):
    return certifies(algebra, data_of(name), reason)


@pytest.mark.slow
@subcases("name", FIELDS)
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
            for place in (number(11), INFINITY, split(11, 3), prime(2, 1), ideal(11), real(0)):
                if place != data["place"]:
                    assert not is_certified(A.name, name, {**data, "place": place})
    assert seen == {True, False}


@pytest.mark.parametrize("by", ["ordering", "level"])
def test_what_holds_over_the_global_field_alone_is_not_used(by):
    assert is_certified("(-1,-1|QQ)", "QQ", {"by": by})
    assert not is_certified("(-1,-1|Qp(5))", "Qp(5)", {"by": by})
    name = "QQ(sqrt(2))_(7, sqrt(2)-3)"
    assert not is_certified(f"(-1,-1|{name})", name, {"by": by})


@subcases(
    ("of", "place", "why"),
    [
        *((QQ, number(n), "are at prime numbers") for n in (4, 15, 3215031751)),
        *((QQ, number(n), "a prime number must be") for n in (1, "x", "5", 5.0, None, True)),
        (ROOT, number(7), "two places of QQ.sqrt.2.. lie above 7"),
        (ROOT, number(15), "are at prime numbers"),
        (quadratic(17), number(2), "two places of QQ.sqrt.17.. lie above 2"),
        (ROOT, split(7, 5), "√2 is not 5"),
        (ROOT, split(21, 3), "are at prime numbers"),
        (functions(finite(3), "t"), prime(2, 0, 1), "is reducible"),
        (functions(finite(3), "t"), prime(1, 2), "is monic"),
        (functions(QQ, "x"), prime(0, 1), "no place of the kind 'prime polynomial'"),
        (functions(QQ, "x"), INFINITY, "no place of the kind 'infinity'"),
        *((of, number(5), "the completions of .* are not known here") for of in (ZZ, RR, CC, finite(5))),
        (multiquadratic(2, 3), number(5), "the completions of .* are not known here"),
        (completion(QQ, number(5)), number(5), "the completions of .* are not known here"),
        (CUBE, ideal(5), "reducible"),
        (CUBE, ideal(5, -2, 1, 0), "is not a prime ideal"),
        (CUBE, other(5, [2, 1], [0, 1, 0]), "given in the generator of the field"),
        *((CUBE, real(n), "the real place number . is not known here") for n in (1, 2, 3)),
        *((CUBE, real(n), "number must be") for n in (-1, "0", None)),
        (CUBE, {**real(0), "sign": "-"}, "unknown key"),
        (CUBE, {"kind": "complex", "number": 1}, "no place of the kind 'complex'"),
        *((of, real(0), "is not known here") for of in (quadratic(-1), QQ, cyclotomic(5), RR)),
        (ROOT, real(1), "the real place number 1 is not known here"),
        *((of, "5", "a place must be an object") for of in (QQ, CUBE, ZZ)),
        *((of, number(5), "the data of a ring must be an object") for of in ("QQ", None, [QQ])),
    ],
)  # fmt: skip
def test_what_is_no_completion_is_refused(of, place, why):
    with pytest.raises(Rejected, match=why):
        read_ring(completion(of, place))


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


@subcases(
    ("changes", "why"),
    [
        ({"root": "0"}, "not so near"),
        ({"root": "3"}, "not so near"),
        ({"root": "1/7"}, "without 7 in a denominator"),
        ({"root": "x"}, "not an element"),
        ({"ring": quadratic(-1)}, "not so near|not that of the certificate"),
        ({"ring": QQ}, "not a number field"),
        ({"ring": quadratic(-5)}, "not so near|not that of the certificate"),
        ({"ring": quadratic(-4)}, "squarefree"),
        ({"ring": "QQ(I)"}, "must be an object"),
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
        with pytest.raises(
            Rejected, match=r"Hensel|p-adic|does not show|not a number field|one equation"
        ):
            check(about_field(data, field))
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
