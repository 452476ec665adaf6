"""What a proof over every commutative ring says of one field is what the prover finds there."""

from hfield.fields.names import ring
from hfield.ledger.propositions import Assertion
from hfield.ledger.transfer import from_general_proof
from hfield.prover.decide import decide
from tests.subcases import subcases

FIELDS = ("QQ", "GF(2)", "GF(3)", "GF(9)", "QQ(sqrt(-7))", "GF(2)(t)", "RR")


@subcases("field", FIELDS)
@subcases(
    "formula",
    [
        "(p*q)*r == p*(q*r)",
        "p*q == q*p",
        "2 == 0 => p*q == q*p",
        "3*s == 0 and s == 1 => p*q == 2*p*q - q*p",
        "s**2 == 2 and 3*y == 1 => (s*y)**2 == 2*y**2",
        "p*q == e => q*p == e",
        "x == 0 => x*p == 0",
        "t*p == e => p*t == e",
        "norm(q) != 0 => q*inv(q) == e",
        "exists q: q*q == -e",
        "y**2 + s**2 == 1 => (y + s*i)*(y - s*i) == 1",
    ],
)
def test_the_verdict_is_that_of_the_field(formula: str, field: str) -> None:
    assert Assertion(formula).decide(ring(field)).verdict == decide(formula, field).verdict


def test_what_is_carried() -> None:
    assert from_general_proof("(p*q)*r == p*(q*r)", (), ring("GF(9)")) is not None
    assert from_general_proof("p*q == q*p", (), ring("GF(2)")) is None  # not over every ring
    assert from_general_proof("2 == 0 => p*q == q*p", (), ring("GF(3)")) is None  # vacuous there
    assert from_general_proof("p*q == q*p", ("2 == 0",), ring("GF(2)")) is not None
    assert (
        from_general_proof("x*p == p*x", (), ring("GF(9)")) is None
    )  # x is an element of the field
    assert (
        from_general_proof("s**2 == 2 => s**4 == 4", (), ring("QQ")) is None
    )  # no integers satisfy it
    assert from_general_proof("(p*q)*r == p*(q*r)", (), ring("RDF")) is None
