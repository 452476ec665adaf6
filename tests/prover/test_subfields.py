"""Over ℚ_p: what is decided in a subfield ℚ(√d), where the numbers of Hensel's lemma are exact."""

import itertools
from fractions import Fraction

import pytest

from hfield import QuaternionAlgebra, prove, ring
from hfield.checker.check import Rejected, check
from hfield.prover.decide import decide
from tests.checker.cases import about_field
from tests.subcases import subcases


@pytest.mark.slow
@subcases(
    ("statement", "algebra", "verdict"),
    [
        ("norm(q) == 0 => q == 0", "H(Qp(5))", "refuted"),
        ("norm(q) == 0 => q == 0", "H(Qp(7))", "refuted"),
        ("norm(q) == 0 => q == 0", "(-1,17|Qp(2))", "refuted"),
        ("p*q == 0 => p == 0 or q == 0", "(2,3|Qp(5))", "refuted"),
        ("norm(q) == 0 => q == 0", "(2,5|Qp(5))", "proved"),
        ("exists s: s*s == -1", "H(Qp(5))", "proved"),
        ("exists s: s*s == -1", "H(Qp(7))", "refuted"),
        ("exists q: q*q == 3*e", "H(Qp(5))", "proved"),
        ("exists s: s*s == -7", "H(Qp(2))", "proved"),
        ("exists s: s**3 == 2", "H(Qp(5))", "proved"),
        ("s**3 != 2", "H(Qp(5))", "refuted"),
        ("exists s: s**3 == 2", "H(Qp(7))", "refuted"),
        ("s**3 != 2", "H(Qp(7))", "proved"),
        ("exists z: 3*z**4 + z == 3/5", "H(Qp(7))", "proved"),
        ("exists z: 3*z**4 + z == 3/5", "H(Qp(5))", "refuted"),
        ("norm(q) == 0 => q == 0", "(2+O(5^3),3|Qp(5))", "undecided"),
    ],
)
def test_verdicts(statement, algebra, verdict):
    decision = prove(statement, algebra=algebra)
    assert decision.verdict == verdict
    F = QuaternionAlgebra.from_text(algebra).ring
    for texts in (decision.witness or {}).values():
        for text in texts:
            assert F(text) is not None  # the field reads a witness back


@pytest.mark.parametrize("p", [2, 3, 5, 7])
def test_a_cubic_has_a_root_exactly_where_one_is_seen_modulo_a_power(p):
    """With v the order of the discriminant at p, a root modulo p^(2v + 1) is near a root in ℚ_p (Hensel)."""
    F = ring(f"Qp({p})")
    for b, c in itertools.product((-1, 0, 2), (-3, -1, 1, 2, 4)):
        discriminant = abs(-4 * b**3 - 27 * c * c)
        v = next(n for n in range(20) if discriminant % p ** (n + 1))
        modulus = p ** (2 * v + 1)
        seen = modulus < 20_000 and any((x**3 + b * x + c) % modulus == 0 for x in range(modulus))
        if modulus < 20_000:
            found = prove(f"exists s: s**3 + ({b})*s + ({c}) == 0", field=F)
            assert found.verdict == ("proved" if seen else "refuted"), (p, b, c)
            assert found.verdict == "refuted" or check(found.certificate).verdict == "proved"


def test_a_root_has_to_be_near():
    """The certificate names a number; one that is near no root of the modulus is refused."""
    data = prove("exists s: s**3 == 2", field="Qp(5)").certificate
    assert check(data).field == "Qp(5)"
    for other in (0, 1, 2, 4, 5, Fraction(3, 5)):
        with pytest.raises(Rejected, match="Hensel"):
            check({**data, "evidence": {**data["evidence"], "root": str(other)}})
    with pytest.raises(Rejected, match="Hensel"):
        check(about_field(data, "Qp(7)"))
    ring = {**data["evidence"]["ring"], "modulus": [-8, 0, 0, 1]}
    with pytest.raises(Rejected, match="may be reducible"):
        check({**data, "evidence": {**data["evidence"], "ring": ring, "root": "2"}})


def test_a_witness_in_a_subfield_is_one_as_far_as_the_digits_go():
    decision = decide("norm(q) == 0 => q == 0", algebra="H(Qp(7))")
    A = QuaternionAlgebra("Qp(7)", -1, -1)
    q = A(*(A.ring(text) for text in decision.witness["q"]))
    assert A.ring.vanishes(q.norm())
    assert any(x.has_value for x in q.coordinates)
    assert "Hensel" in decision.steps[0]


@pytest.mark.parametrize("p", [3, 5, 7, 13])
def test_a_number_is_a_square_where_its_class_says_so(p):
    F = ring(f"Qp({p})")
    for d in (-1, 2, -2, 3, 6, 7):
        found = decide(f"exists s: s*s == {d}", F).verdict
        assert found == ("proved" if F.is_square(F(d)) else "refuted"), (p, d)


def test_what_does_not_carry_over_is_not_taken_from_a_subfield():
    """Everything in ℚ(√d) being a root of something, or all having one there, says nothing of ℚ_p."""
    for statement in ("exists q: q*p == e", "exists s: s*s == t"):
        assert prove(statement, field="Qp(5)", timeout=5).verdict != "proved"
