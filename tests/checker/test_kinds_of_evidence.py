"""Kinds of evidence: the folder is the list; and what an evaluation takes for a scalar."""

from pathlib import Path

import pytest

from hfield.checker import evidence
from hfield.checker.evaluate import Evaluator, RingScalars
from hfield.checker.evidence import checks
from hfield.checker.language import parse
from hfield.checker.rejection import Rejected
from hfield.checker.statement import HAMILTON
from tests.checker.ring_data import read_field
from tests.subcases import subcases

MODULES = {p.stem for p in Path(evidence.__file__).parent.glob("*.py")} - {"__init__"}


def test_every_module_of_the_folder_is_read():
    def home(check):
        return getattr(check, "func", check).__module__

    assert {home(check).rpartition(".")[2] for check in checks().values()} == MODULES


def test_what_each_kind_shows_is_one_of_the_verdicts():
    assert {verdict for verdict, _, _ in checks()} == {"proved", "refuted", "vacuous"}
    assert ("refuted", False, "identity") not in checks()
    assert ("proved", True, "none exists") not in checks()


@subcases("name", ["QQ", "GF(5)", "GF(9)", "QQ(sqrt(2))"])
@subcases("text", ["1/i", "q/p", "e/(1+j)"])
def test_what_divides_is_a_scalar(name, text):
    """Elements of GF(9) are tuples as quaternions are: one must not pass for the other."""
    ring = read_field(name)
    evaluator = Evaluator(RingScalars(ring), HAMILTON, {})
    q = evaluator.value(parse("1+i+2*k"))
    evaluator = Evaluator(RingScalars(ring), HAMILTON, {("name", x): q for x in "pq"})
    with pytest.raises(Rejected, match="a quaternion stands where a scalar is meant"):
        evaluator.value(parse(text))
