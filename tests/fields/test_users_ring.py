"""The ring that docs/reference/rings.md builds from scratch, through the axioms and into quaternions."""

from fractions import Fraction

import pytest

from hfield import H, QuaternionAlgebra, check_ring, info, prove
from hfield.errors import CoercionError, HFieldError, RingError, UndecidedError
from hfield.fields import Ring
from hfield.fields.names import ring
from hfield.prover.evaluation import all_cases
from hfield.prover.problem import MEMORY
from tests.subcases import subcases

from .axioms import CHECKS


@subcases("base", ["QQ", "GF(3)", "GF(2)"])
@subcases("check", CHECKS)
def test_axiom(dual_numbers, base, check):
    check(dual_numbers(ring(base)))


def test_quaternions_over_it(dual_numbers):
    A = H(dual_numbers(ring("QQ")))
    p, q = A("1 + eps*i + 2*j"), A("3*i - eps*k")
    assert (p * q).norm() == p.norm() * q.norm()
    assert A("eps*j").is_zero_divisor()
    assert not q.is_zero_divisor()
    assert q * q.inverse() == 1


class Mine(Ring):
    """Fractions, of which the ring says no more than it must."""

    characteristic = 0

    def __init__(self, name="mine"):
        self.name = name

    def __call__(self, x):
        return self.parse(x) if isinstance(x, str) else Fraction(x)


class Whole(Mine):
    """Python's integers, which do not divide."""

    def __call__(self, x):
        if isinstance(x, float):
            raise CoercionError("no float is an integer")
        return self.parse(x) if isinstance(x, str) else int(x)


def test_what_a_ring_does_not_say_is_not_known():
    A, B = H(Mine()), H(Whole())
    assert A(1, 2, 3, 4).is_unit()
    assert A(1, 2, 3, 4) * A(1, 2, 3, 4).inverse() == 1
    assert not A(0, 0, 0, 0).is_unit()
    assert B(0, 1, 0, 0).is_unit()
    assert not A(1, 2, 3, 4).is_zero_divisor()
    for ask in (
        A.is_division_algebra,
        A.is_central_simple,
        A.zero_norm_element,
        A.split,
        B.is_division_algebra,
        B(1, 2, 3, 4).is_unit,
        B(1, 2, 3, 4).is_zero_divisor,
        B(1, 2, 3, 4).inverse,
    ):
        with pytest.raises(UndecidedError, match="not known"):
            ask()
    about = info(A)
    assert about.division is None
    assert "division" in about.undecided
    with pytest.raises(RingError, match="over mine, is not written for sage"):
        A.text_for("sage")


class Residue:
    """A class modulo 6 that is not a number and does not divide."""

    def __init__(self, n):
        self.n = n % 6

    def __add__(self, other):
        return Residue(self.n + other.n)

    def __sub__(self, other):
        return Residue(self.n - other.n)

    def __mul__(self, other):
        return Residue(self.n * other.n)

    def __neg__(self):
        return Residue(-self.n)

    def __eq__(self, other):
        return isinstance(other, Residue) and self.n == other.n

    def __hash__(self):
        return hash(self.n)

    def __str__(self):
        return str(self.n)


class Residues(Ring):
    """ℤ/6, without saying which elements are units."""

    name, characteristic, order = "residues", 6, 6

    def __call__(self, x):
        if isinstance(x, str):
            return self.parse(x)
        return x if isinstance(x, Residue) else Residue(int(x))

    def elements(self):
        return map(Residue, range(6))

    def random(self, rng):
        return Residue(rng.randrange(6))


@pytest.mark.parametrize("few", [0, 1_500])
@pytest.mark.parametrize(
    ("statement", "verdict"),
    [
        ("x != 0 => inv(x)*x == 1", "undecided"),  # false for x = 2
        ("inv(x)*x == 1 or x == 0", "undecided"),
        ("x == 5 => inv(x)*x == 1", "proved"),
        ("inv(x)*x != 1", "refuted"),  # 1/1 is known
        ("x**3 == x", "proved"),
        ("x*y == 0 => x == 0 or y == 0", "refuted"),
        ("exists x: inv(x)*x == 1 and x != 1", "proved"),  # −1
        ("exists x: inv(x) == 1 and x != 1", "undecided"),
    ],
)
def test_cases_in_which_units_are_not_known_prove_nothing(statement, verdict, few, monkeypatch):
    MEMORY.cache_clear()
    monkeypatch.setattr(all_cases, "FEW_CASES", few)
    A = QuaternionAlgebra(Residues(), 1, 1, 1)
    assert prove(statement, algebra=A).verdict in (verdict, "undecided" if few == 0 else verdict)
    # its zero norms are not known: elements need not be numbers
    assert prove(statement, Residues()).verdict in (verdict, "undecided" if few == 0 else verdict)


@pytest.mark.parametrize("ring_class", [Mine, Whole])
def test_no_ring_is_said_to_be_no_field_where_that_is_not_known(ring_class):
    A = H(ring_class())
    for ask in (
        A.polynomials()("x^2 + 1").roots,
        A.matrix([["2"]]).rank,
        lambda: A.matrix([["2"]]).diagonal_form(),
    ):
        with pytest.raises(HFieldError, match="mine is not known to be a field"):
            ask()


@pytest.mark.parametrize("name", ["QQ", "ZZ", "GF(7)", "RR", "ZZ[a,b]"])
def test_no_name_makes_a_ring_one_of_ours(name):
    R = Mine(name)
    assert ring(name) != R
    assert ring(name) != R
    assert Mine(name) == R
    assert H(R) != H(ring(name))
    found = prove("p*q == q*p", algebra=H(R))
    assert found.verdict == "refuted"
    assert found.certificate is None
    assert "does not know the ring" in found.why_no_certificate
    # it is not known to be a field, where ℚ is one
    assert prove("norm(q) == 0 => q == 0", algebra=H(R)).verdict == "undecided"
    with pytest.raises((HFieldError, AttributeError)):
        H(R).maximal_order()


def test_samples_show_what_is_wrong():
    assert check_ring(Mine())
    assert "not known" in str(check_ring(Whole()))
    wrong = {
        "characteristic": {"characteristic": 5},
        "F.text(x)": {"text": lambda self, x, style="plain": str(x + 1)},
        "F.key(x)": {"key": lambda self, x: x * x},
        "F.inverse(x)": {"inverse": lambda self, x: x},
        "F.is_unit(x)": {"is_unit": lambda self, x: True},
        "F.annihilator(x)": {"annihilator": lambda self, x: x},
        "F.elements()": {
            "order": 2,
            "elements": lambda self: iter([Fraction(0), Fraction(1), Fraction(2)]),
        },
        "1 ≠ 0": {"zero": property(lambda self: Fraction(1))},
        "TypeError": {"random": lambda self, rng: "1"},
    }
    for text, changes in wrong.items():
        report = check_ring(type("Wrong", (Mine,), changes)())
        assert not report, text
        assert any(text in line for line in report.failed), (text, report)


@pytest.mark.parametrize("name", ["QQ", "GF(9)", "ZZ/6", "Qp(5)", "RDF", "GF(2)(t)"])
def test_ours_pass(name):
    report = check_ring(ring(name))
    assert report
    assert not report.unknown
