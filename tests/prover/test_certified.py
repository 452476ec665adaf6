"""A verdict has a certificate that the checker accepts: statements with known verdicts, over many rings."""

import pytest

from hfield.errors import NotationError
from hfield.prover.prove import prove
from tests.prover.statements import DEPENDS, FALSE, FIELDS, UNIVERSAL
from tests.subcases import first_quick, subcases

STATEMENTS = [*UNIVERSAL, *FIELDS, *FALSE, *DEPENDS]
RINGS = [
    None,
    *("QQ", "RR", "CC", "GF(2)", "GF(3)", "GF(4)", "GF(5)", "GF(7)", "GF(8)", "GF(9)", "GF(13)"),
    *("GF(25)", "QQ(sqrt(2))", "QQ(I)", "QQ(sqrt(-7))", "QQ(sqrt(-3))", "QQ(x)", "GF(2)(t)"),
    *("GF(5)(t)", "ZZ", "ZZ/4", "ZZ/6", "ZZ/9", "ZZ[a,b]", "QQ[x]"),
]
SHARE = 7  # of the statements one in so many over each ring, others over the next


@pytest.mark.parametrize("part", first_quick([1, 0, 2, 3], 1))
@subcases(("n", "ring"), list(enumerate(RINGS)))
def test_what_is_decided_has_a_certificate(n, ring, part):
    decided = 0
    for statement in STATEMENTS[n % SHARE + part * SHARE :: 4 * SHARE]:
        try:
            answer = prove(statement, ring, timeout=5)
        except NotationError:  # the generator of the field is no unknown
            continue
        if answer.verdict != "undecided":
            decided += 1
            assert answer.certificate is not None, (statement, ring, answer.why_no_certificate)
    assert decided >= 1


ALGEBRAS = [
    ("norm(q) == 0 => q == 0", "(2,3|QQ)"),
    ("a != 0", "(1/a,-1|QQ)"),
    ("a == 0 => i*i == 0", "(1/a,1|GF(3))"),
    ("2*q == 0 => q == 0", "(1/2,b|F)"),
    ("a == 2", "(1/(a*a-a),1|GF(3))"),
    ("exists s: s*a == 1", "(1/a,b|F)"),
    ("exists s: s*a == 1", "(a,b|F)"),
    ("exists p: p != 0 and norm(p) == 0", "(a,b|F)"),
    ("exists u: u*q + conj(u) == s", "(1/a,b|F)"),
    ("trace(q) == 0 => (exists u: q*u == -u*q and u != 0)", "(-1,-3|QQ)"),
]


@subcases(("statement", "algebra"), ALGEBRAS)
def test_statements_about_other_algebras_are_certified(statement, algebra):
    answer = prove(statement, algebra=algebra)
    assert answer.certificate is not None, answer.why_no_certificate


CONSTANTS_LEFT_OUT = [
    ("q == 0 => q*q == conj(k) => s != s - (I + 1)", "QQ(I)", None),
    ("q == 0 and q*q == i => i == 0 or x == 0", "GF(8)", None),
    ("q == 0 and conj(i) == q*q => s + I == 0 or k == q*q", "QQ(I)", "(-1,1/(a-1)|QQ(I))"),
    ("y**2 == -1 and y == 3 => y == x", "QQ(x)", "(x,-1|QQ(x))"),
    ("s != 0 => (exists y: s*y == I)", "QQ(I)", None),
    ("s**2 == 2 => (exists y: s*y == sqrt(3))", "RR", None),
]


@pytest.mark.parametrize(("statement", "field", "algebra"), CONSTANTS_LEFT_OUT)
def test_a_proof_about_a_part_speaks_of_its_constants_alone(statement, field, algebra):
    answer = prove(statement, field, algebra=algebra)
    assert answer.verdict in ("proved", "vacuous")
    assert answer.certificate is not None, answer.why_no_certificate
