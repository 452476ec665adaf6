"""Certificates over 𝔽_q[t]: what is true is accepted, what is false is not; reduced bases are reduced."""

import random
from functools import cache
from typing import Any

import pytest

from hfield import QuaternionAlgebra, ring
from hfield.checker.check import Budget, check
from hfield.checker.glossary import MASS_OVER_POLYNOMIALS
from hfield.checker.number_fields.matrices import hermite, times
from hfield.checker.orders.polynomial_integers import PolynomialIntegers
from hfield.checker.orders.reading import OverPolynomials
from hfield.checker.orders.words import OVER_POLYNOMIALS
from hfield.checker.rejection import Rejected
from hfield.checker.scalars.fields import read_ring
from hfield.checker.scalars.finite_field_polynomials import FiniteFieldPolynomial
from hfield.checker.statement import read_setting
from hfield.cli import main
from hfield.orders import certificates
from hfield.orders.lattice_values import colon
from tests.checker.cases import Certificate
from tests.checker.order_certificates import rejects
from tests.subcases import slow

CASES = (("GF(3)(t)", "t^3+2*t+1", 1), ("GF(2)(t)", "t^3+t+1", "t"), ("GF(4)(t)", "t^2+t+x", "t"))


@cache
def genuine(field: str, P: str, level: Any) -> dict[str, Certificate]:
    """Certificates about an Eichler order, an ideal that is not principal and isomorphisms."""
    A = QuaternionAlgebra.from_ramification(field, [P, "inf"])
    O, x = A.eichler_order(level), A(1, 1, 0, 1)
    C = O.class_set()
    I = next(I for I in C if not I.is_principal())
    other = next(J.left_order() for J in C if not O.isomorphism(J.left_order()))
    found = {
        "order": O.claim, "classes": C.claim, "ideal": I.claim, "apart": I.is_principal().claim,
        "equal": (x * I).equivalence(I).claim,
        "moved": O.isomorphism((x * O * x.inverse()).left_order()).claim,
        "other": O.isomorphism(other).claim,
        "units": certificates.of_unit_index(O.value, O.unit_index()),
    }  # fmt: skip
    every = {name: claim.certificate for name, claim in found.items()}
    assert all(data is not None for data in every.values())
    return every  # type: ignore[return-value]


@pytest.mark.parametrize("case", [*CASES[:2], slow(CASES[2])])
def test_what_is_true_is_accepted(case: tuple[str, str, Any]) -> None:
    shown = set()
    for data in genuine(*case).values():
        cites = check(data).assumes
        word = data["statement"].partition("{")[0]
        shown.add((word, data["verdict"]))
        assert cites == ((MASS_OVER_POLYNOMIALS,) if word.startswith("class-set") else ())
    assert shown == OVER_POLYNOMIALS.keys()


def with_evidence(data: Certificate, **changes: Any) -> Certificate:
    return {**data, "evidence": {**data["evidence"], **changes}}


def stating(data: Certificate, *parts: str) -> Certificate:
    """Return a certificate with other last parts in its statement."""
    word, _, inside = data["statement"][:-1].partition("{")
    kept = inside.split("; ")[: -len(parts)]
    return {**data, "statement": f"{word}{{{'; '.join([*kept, *parts])}}}"}


@pytest.mark.parametrize("case", [*CASES[:2], slow(CASES[2])])
def test_class_sets_that_are_forged(case: tuple[str, str, Any]) -> None:
    data = genuine(*case)["classes"]
    classes, primes = data["evidence"]["classes"], data["evidence"]["primes"]
    h = len(classes)
    fewer = with_evidence(data, classes=classes[1:])
    rejects(fewer, "which is not the number that is stated")
    rejects(stating(fewer, str(h - 1)), "do not have the mass")
    twice = with_evidence(data, classes=[*classes[1:], classes[-1]])
    rejects(twice, "are in one class")
    rejects(
        stating(with_evidence(data, classes=[*classes, classes[0]]), str(h + 1)), "in one class"
    )
    rejects(with_evidence(data, primes=primes[1:]), "not all given")
    rejects(with_evidence(data, primes=[*primes, primes[0]]), "does not divide")
    rejects(with_evidence(data, primes=[*primes, "t^4*(t^2+t)"]), "reducible")
    rejects(with_evidence(data, primes=[*primes, "1"]), "a monic polynomial")
    rows = classes[0].split(" | ")
    skew = [*rows[:3], skewed(data, rows[3], rows[0])]
    rejects(with_evidence(data, classes=[" | ".join(skew), *classes[1:]]), "not reduced")
    no_ideal = "t,0,0,0 | 0,1,0,0 | 0,0,1,0 | 0,0,0,1"
    rejects(with_evidence(data, classes=[no_ideal, *classes[1:]]), "no right ideal")


def skewed(data: Certificate, element: str, by: str) -> str:
    """Return the sum of an element and t⁵ times another one."""
    A = QuaternionAlgebra.from_text(data["algebra"])
    x, y = (A(*map(A.ring, text.split(","))) for text in (element, by))
    return ",".join(map(A.ring.text, (x + y * A.ring("t^5")).coordinates))


@pytest.mark.parametrize("case", [*CASES[:2], slow(CASES[2])])
def test_other_statements_that_are_forged(case: tuple[str, str, Any]) -> None:
    every = genuine(*case)
    D = every["order"]["statement"][:-1].split("; ")[-1]
    for wrong in (f"({D})*t", f"({D})/(t^3+t)", "1"):
        rejects(stating(every["order"], wrong), "discriminant")
    rejects(stating(every["order"], "0"), "monic")
    rejects(stating(every["ideal"], "t^9"), "another norm")
    rejects(stating(every["units"], "7"), "another number of units")
    rejects(with_evidence(every["equal"], element="1,0,0,0"), "does not carry")
    rejects(with_evidence(every["equal"], element="0,0,0,0"), "not all of them 0")
    basis = every["apart"]["evidence"]["between"]
    first = every["apart"]["statement"].split("; ")[1]
    rejects(stating(every["apart"], first), "no basis")
    rejects(with_evidence(every["apart"], between=basis.partition(" | ")[2]), "4 elements")
    rejects(with_evidence(every["moved"], element="1,0,0,0"), "does not conjugate")
    pair = every["other"]["evidence"]["pair"]
    rejects(with_evidence(every["other"], pair=[pair[0], pair[0]]), "do not generate")
    order = every["order"]["statement"].partition("{")[2].split("; ")[0]
    same = with_evidence(stating(every["other"], order), order=every["units"]["evidence"]["order"])
    rejects(same, "there is an isomorphism")


def test_ideals_that_are_equivalent_are_not_shown_to_differ() -> None:
    data = genuine(*CASES[0])["equal"]
    side, *texts = data["statement"][:-1].partition("{")[2].split("; ")
    A = QuaternionAlgebra.from_text(data["algebra"])
    first, second = (A.lattice([row.split(",") for row in x.split(" | ")]).value for x in texts)
    between = colon(second, first, "left" if side == "right" else "right")
    rows = between.elements(between.reduced[0])
    basis = " | ".join(",".join(map(A.ring.text, q.coordinates)) for q in rows)
    evidence = {"kind": data["evidence"]["kind"], "between": basis}
    forged = {**data, "verdict": "refuted", "method": "enumeration", "evidence": evidence}
    rejects(forged, "an element carries")


def test_an_algebra_that_splits_at_infinity_has_no_reduced_bases() -> None:
    A = QuaternionAlgebra.from_text("(1,t|GF(3)(t))")
    O = A.maximal_order()
    text = certificates.text(O.value)
    word = "unit-index-over-polynomials"
    data = genuine(*CASES[0])["units"]
    forged = {**data, "algebra": str(A), "statement": f"{word}{{{text}; 1}}"}
    rejects(with_evidence(forged, order=text), "reduced|infinity")
    # the leading terms of the norms 1, 1, t, t are independent, and there are elements of norm 0
    given = OverPolynomials(read_setting(str(A), read_ring(data["ring"])), {})
    hidden = "1,0,0,0 | 0,0,2-2/t,2+2/t | t^5,t^5,0,1 | 2*t+1,2*t+2,1,0"
    with pytest.raises(Rejected, match="too large a degree"):
        _ = given.lattice(hidden).degrees


@pytest.mark.parametrize("case", CASES)
def test_in_a_reduced_basis_no_leading_terms_cancel(case: tuple[str, str, Any]) -> None:
    data, rng = genuine(*case)["units"], random.Random(1)
    given = OverPolynomials(read_setting(data["algebra"], read_ring(data["ring"])), {})
    order = given.lattice(data["evidence"]["order"])
    small = list(given.polynomials.of_degree_below(2))
    for _ in range(50):
        numbers = rng.choices(small, k=4)
        both = [(c, d) for c, d in zip(numbers, order.degrees, strict=True) if c]
        found = order.algebra.norm(times([numbers], order.rows)[0]).degree
        assert found == max((2 * c.degree + d for c, d in both), default=-1)
    degree = sorted(order.degrees)[2]
    listed = list(order.up_to_degree(degree))
    assert len(set(listed)) == len(listed)
    assert all(order.algebra.norm(x).degree <= degree for x in listed)
    exponents = [max((degree - d) // 2 + 1, 0) for d in order.degrees]
    assert len(listed) == given.polynomials.order ** sum(exponents)


@pytest.mark.parametrize("field", ["GF(3)(t)", "GF(4)(t)"])
def test_polynomials_compute_as_those_of_flint_do(field: str) -> None:
    F, rng = ring(field), random.Random(3)
    setting = read_setting(f"[1,t|{field})", read_ring(F.data))
    polynomials = PolynomialIntegers(setting)
    every = list(polynomials.of_degree_below(3))

    def to_flint(f: FiniteFieldPolynomial) -> Any:
        value = F.zero
        for c in reversed(f.coefficients):
            digits = [c] if isinstance(c, int) else c
            text = "+".join(f"{d}*x^{n}" if n else str(d) for n, d in enumerate(digits))
            value = value * F("t") + F(text)
        return value.num

    for _ in range(40):
        f, g, h = rng.choices(every, k=3)
        assert to_flint(f * h + g) == to_flint(f) * to_flint(h) + to_flint(g)
        assert to_flint(f - g) == to_flint(f) - to_flint(g)
        if g:
            q, r = divmod(f * h, g)
            assert (to_flint(q), to_flint(r)) == divmod(to_flint(f * h), to_flint(g))
            assert to_flint(f.gcd(g, 0)) == to_flint(f).gcd(to_flint(g))
    first = hermite([rng.choices(every, k=4) for _ in range(5)])
    assert hermite([*reversed(first), *times([rng.choices(every, k=4)], first)]) == first


def test_the_command_line_writes_and_checks_them(tmp_path: Any, capsys: Any) -> None:
    path = str(tmp_path / "classes.json")
    assert main(["classes", "(-1,t^3+2*t+1|GF(3)(t))", "--certificate", path]) == 0
    assert main(["check", path]) == 0
    assert MASS_OVER_POLYNOMIALS in capsys.readouterr().out


def test_work_is_bounded() -> None:
    data = genuine(*CASES[2])["other"]
    with pytest.raises(Rejected, match="more work"):
        check(data, None, Budget(0.01))
