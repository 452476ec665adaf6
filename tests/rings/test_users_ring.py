"""The ring that docs/rings.md builds from scratch, through the axioms and into quaternions."""

from hfield import H
from hfield.rings import ring
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
