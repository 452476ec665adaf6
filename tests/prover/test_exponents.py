"""Products of powers too large to expand: by their exponents, and the checker's own bound on them."""

import pytest

from hfield import prove
from hfield.checker.check import Rejected, check
from hfield.prover.decide import decide
from tests.subcases import subcases


@pytest.mark.slow
@subcases("field", [None, "GF(4)", "ZZ/6"])
@subcases(
    "statement",
    [
        "s**65537 == s*s**65536",
        "(-s)**65537*t == -(s**65536*t)*s",
        "(2*s*t)**40000 == (2**2*s**2*t**2)**20000",
        "(s**100000)**100000 == s**10000000000",
        "s == 3 => s**65537 == s*s**65536",
    ],
)
def test_exponents_add_up(statement, field):
    decision = decide(statement, field=field, timeout=5)
    assert (decision.verdict, decision.method) == ("proved", "identity")
    assert decision.scope == "commutative rings"


@pytest.mark.slow
@pytest.mark.parametrize(
    "statement",
    [
        "s**65537 == s*s**65537",
        "(-s)**65537 == s**65537",
        "s**65537*t == s*s**65536",
        "s**65537 == s*s**65536 and s**65537 == s**2",
        "s**65537 != s*s**65536",
        "3*s**65537 == 2*s**65537",
        "(-1)**65537*s**65537 == s**65537",
        "0*s**65537 == s**65537",
    ],
)
def test_other_exponents_are_others(statement):
    for field in (None, "GF(5)"):
        assert decide(statement, field=field, timeout=2).verdict != "proved"


def test_the_checker_has_its_own_bound():
    """A certificate is written as far as the checker multiplies out, and no further."""
    near = prove("s**9000 == s*s**8999").certificate
    assert check(near).verdict == "proved"
    assert prove("s**65537 == s*s**65536").certificate is None
    for statement in ("s**65537 == s*s**65536", "s**9001 == s*s**8999", "s**65536*t == t*s"):
        with pytest.raises(Rejected):
            check({**near, "statement": statement})
