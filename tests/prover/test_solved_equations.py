"""Equations that a textbook solves: two-sided ones, linear ones and roots in rings, polynomials in H(ℝ)."""

from itertools import product

import pytest

from hfield import prove, ring
from hfield.checker.check import Rejected, check
from hfield.fields.base.roots import residue_roots
from hfield.prover import prove as proving
from hfield.prover.decide import decide
from hfield.prover.existence.closed_equations import closed_solutions
from hfield.prover.problem import Problem
from hfield.prover.statements.language import read_statement
from hfield.prover.statements.setting import read_setting
from tests.checker.cases import certified
from tests.subcases import first_quick, subcases
from tests.thorough import quick_part

P = 2**64 - 59  # a prime, 5 modulo 8, and 2 modulo 3
N = 2**64 - 2
DECIDED = [
    ("norm(p) != norm(q) => (exists u: p*u - u*q == r)", "QQ", "proved"),
    ("norm(p) != norm(q) => (exists u: p*u - u*q == r)", "CC", "refuted"),
    ("trace(p) != trace(q) => (exists u: p*u == u*q + r)", "RR", "proved"),
    ("trace(p) != trace(q) => (exists u: p*u == u*q + r)", "GF(5)", "refuted"),
    ("norm(p**2 - trace(q)*p + norm(q)) != 0 => (exists u: p*u - u*q == r)", None, "proved"),
    ("exists u: i*u - 2*u*j == r", "QQ", "proved"),
    ("exists u: i*u - u*j == r", "QQ", "refuted"),
    ("norm(p + s) != 0 => (exists u: p*u + s*u == 1)", None, "proved"),
    ("exists s: 2*s == 1", f"ZZ/{N}", "refuted"),
    ("exists s: 2*s == 1", f"ZZ/{N + 1}", "proved"),
    ("exists s: 6*s == 4", f"ZZ/{N}", "proved"),
    ("exists s, t: 1000003*s + 999983*t == 1", "ZZ", "proved"),
    ("exists s, t: 1000002*s + 999984*t == 1", "ZZ", "refuted"),
    ("exists s, t: x*s + (x**2 + 1)*t == 1", "QQ[x]", "proved"),
    ("exists s: s**2 == 2", f"GF({P})", "refuted"),
    ("exists s: s**2 == 5", f"GF({P})", "refuted"),
    ("exists s: s**2 + s == 6", f"GF({P})", "proved"),
    ("exists s: s**2 == -1", f"GF({P})", "proved"),
    ("s**2 != 2", f"GF({P})", "proved"),
    ("exists s: s**2 == 2", f"ZZ/{3 * P}", "refuted"),
    ("exists q: q*q == p", "RR", "proved"),
    ("exists q: i*q**3*j + p*q*r*q == q*s + 1", "RR", "proved"),
    ("exists q: q*q == q**2 + 1", "RR", "refuted"),
    ("exists q: p*q*q == 1", "RR", "refuted"),
    ("exists q: i*q - q*i == 1", "RR", "refuted"),
]


@pytest.mark.slow
@subcases(("text", "field", "verdict"), DECIDED)
def test_textbook(text: str, field: str | None, verdict: str) -> None:
    """The verdict is right, and its certificate is accepted."""
    answer = proving.prove(text, field)
    assert answer.verdict == verdict
    assert answer.certificate is not None, answer.why_no_certificate


def test_residues_of_other_moduli_say_nothing() -> None:
    """That 3 is not a sum of two squares modulo 4 does not matter to an odd modulus."""
    n = 3 + 4 * 10**15
    assert decide(f"exists s, t: s**2 + t**2 == {n}", f"ZZ/{3 * P}").verdict != "refuted"
    assert decide(f"exists s, t: s**2 + t**2 == {n}", f"ZZ/{4 * P}").verdict == "refuted"


def test_without_a_certificate() -> None:
    """That x has no inverse in ℚ[x] is decided, and no certificate is pretended."""
    answer = proving.prove("exists s: x*s == 1", "QQ[x]")
    assert answer.verdict == "refuted"
    assert answer.certificate is None


@pytest.mark.parametrize("n", first_quick([12, 9, 4, 6, 8, 30], 2))
def test_linear_equations_over_residues(n: int) -> None:
    """Two equations in two unknowns over ℤ/n have the solutions that trying all cases finds."""
    setting = read_setting(f"ZZ/{n}")
    for a, b, c, d in quick_part(list(product((0, 1, 2, 3, n - 2), repeat=4)), 3):
        text = f"{a}*s + {b}*t == {c} and {d}*s + 3*t == 2"
        statement = read_statement(text, setting.field)
        places = [
            (s, t)
            for s, t in product(range(n), repeat=2)
            if (a * s + b * t - c) % n == 0 and (d * s + 3 * t - 2) % n == 0
        ]
        found = closed_solutions(Problem(statement, setting))
        assert found.none is not bool(places), text
        assert {(int(x["s"]), int(x["t"])) for x in found.places} <= set(places), text


@pytest.mark.parametrize("n", [2, 8, 27, 12, 45, 72, 101])
def test_roots_modulo_n(n: int) -> None:
    """All roots modulo n, lifted and put together, are those that trying finds."""
    for c in product((0, 1, -1, 2, 5, 9), (0, 1, 3), (0, 1, 2, 9)):
        if any(x % n for x in c):
            expected = [x for x in range(n) if (c[0] + c[1] * x + c[2] * x * x) % n == 0]
            assert residue_roots(c, n) == expected, c


@pytest.mark.parametrize("name", ["GF(9)", "GF(7)", "ZZ", "QQ", "GF(8)"])
def test_roots_in_rings(name: str) -> None:
    """Products of linear factors have the roots that they were made of."""
    R = ring(name)
    a, b = R.one + R.one + R.one, R.zero if R.gen_name is None else R.gen
    roots = R.roots([a * b, R.zero - a - b, R.one])
    assert {R.key(x) for x in roots} == {R.key(a), R.key(b)}


def test_forged_quaternion_roots() -> None:
    """The theorem on quaternion polynomials is not taken for what it does not say."""
    forged = [
        ("exists q: p*q*q == 1", "RR", "(-1,-1|RR)"),
        ("exists q: q*q == q**2 + 1", "RR", "(-1,-1|RR)"),
        ("exists q: i*q - q*i == 1", "RR", "(-1,-1|RR)"),
        ("exists q: q - q == 1", "RR", "(-1,-1|RR)"),
        ("exists q: 0*q*q == 1", "RR", "(-1,-1|RR)"),
        ("exists q: q*conj(q) == -1", "RR", "(-1,-1|RR)"),
        ("exists q: norm(q)*q*q == j and q == 0", "RR", "(-1,-1|RR)"),
        ("exists q: q*q == p", "RR", "(1,-1|RR)"),
        ("exists q: q*q == p", "QQ", "(-1,-1|QQ)"),
        ("exists s: s*s == -1", "RR", "(-1,-1|RR)"),
    ]
    theorem = decide("exists q: q*q == p", "RR").assumes
    for text, field, algebra in forged:
        data = certified(text, field, "witness", {"kind": "quaternion root"}, algebra)
        with pytest.raises(Rejected):
            check({**data, "assumes": list(theorem)})


@subcases("seed", range(12))
def test_quadratics_over_a_field_that_is_not_tried_through(seed: int) -> None:
    """Over GF(1009) and ℤ/(3·1009) a quadratic has a root where trying finds one."""
    a, b, c = (pow(7, seed + 5 * n, 1009) for n in range(3))
    for field, n in (("GF(1009)", 1009), ("ZZ/3027", 3027)):
        roots = any((a * x * x + b * x + c) % n == 0 for x in range(n))
        answer = proving.prove(f"exists s: {a}*s**2 + {b}*s + {c} == 0", field)
        assert answer.verdict == ("proved" if roots else "refuted")
        assert answer.certificate is not None, answer.why_no_certificate
    zero = any((x * x - a * y * y) % 1009 == 0 for x in range(1, 1009) for y in (1,))
    assert decide(f"s**2 == {a}*y**2 => s == 0", "GF(1009)").verdict == (
        "refuted" if zero else "proved"
    )


@subcases(
    ("statement", "field", "verdict"),
    [
        ("exists q: q*q == 2", "QQ(zeta5)", "proved"),
        ("exists q: 2*q*q == 1", "QQ(zeta5)", "proved"),
        ("exists q: q**2 + 3*q == 1/7", "QQ(zeta5)", "proved"),
        ("exists q: q*q == 3 and q != 0", "QQ(zeta5)", "proved"),
        ("exists q: q*q == -7", "QQ(I)_(5, I-2)", "proved"),
        ("exists q: q*q == -7", "QQ(sqrt(2), sqrt(3))", "proved"),
        ("exists q: q**2 + q + 1 == 0", "QQ", "proved"),
        ("exists q: q**2 + q - 1 == 0", "QQ", "refuted"),
        ("exists q: q*q == -7", "QQ", "refuted"),  # 7 is no sum of three squares
        ("exists q: q*q == -7", "QQ[s]/(s^3-2)", "refuted"),
        ("exists q: q**2 == i + 2", "QQ", "refuted"),  # 5 is not a square
        ("exists q: q*q == t", "GF(2)(t)", "refuted"),
        ("exists q: q*q == i*q", "QQ", "proved"),
    ],
)
def test_square_roots_are_decided_by_what_the_field_knows(statement, field, verdict):
    found = prove(statement, field)
    assert found.verdict == verdict
    if verdict == "proved":
        assert found.certificate is not None
        assert check(found.certificate).verdict == "proved"


def test_square_roots_agree_with_the_sum_of_three_squares():
    """Legendre: n is a sum of three rational squares unless it is 4ᵃ·(8b + 7), up to squares."""
    for n in quick_part((*range(1, 16), 23, 28, 31, 39), 3):
        core = n
        while core % 4 == 0:
            core //= 4
        wanted = "refuted" if core % 8 == 7 else "proved"
        assert decide(f"exists q: q*q == -{n}", "QQ").verdict == wanted


def test_identities_of_fractions_over_a_finite_field_have_a_certificate():
    found = prove("q*conj(q) == norm(q)**2", "GF(2)", algebra="(a/b,b|GF(2))")
    assert found.verdict == "proved"
    assert found.certificate is not None
