"""Every ring of ours through every axiom."""

import pytest

from hfield.rings import ring

from .axioms import CHECKS

RINGS = (
    "QQ", "ZZ", "RR", "CC", "RDF",
    "ZZ/2", "ZZ/6", "ZZ/7", "ZZ/8", "ZZ/100", "ZZ/100000000000000000041", f"ZZ/{3 * 2**70}",
    "GF(2)", "GF(7)", "GF(100000000000000000039)", "GF(9223372036854775783)",
    "GF(4)", "GF(9)", "GF(256)", "GF(9, x^2+1)", "GF(16, x^4+x^3+1)",
    "GF(2^100)", "GF(100000000000000000039^2)",
    "QQ(sqrt(2))", "QQ(sqrt(5))", "QQ(sqrt(30))", "QQ(I)", "QQ(sqrt(-2))", "QQ(sqrt(-3))",
    "QQ(sqrt(-7))", "QQ(sqrt(-163))",
    "QQ(x)", "QQ(t)", "GF(2)(t)", "GF(5)(t)", "GF(4)(t)", "GF(9, x^2+1)(t)",
    "GF(100000000000000000039)(t)", "GF(7)(x)",
    "ZZ[a,b,c]", "QQ[x,y]", "GF(5)[x,y]", "QQ[x]", "GF(2)[x,y]", "GF(100000000000000000039)[x,y]",
    "ZZ[a_1,b2,alpha,w,z]",
)  # fmt: skip


@pytest.mark.parametrize("name", RINGS)
@pytest.mark.parametrize("check", CHECKS, ids=lambda f: f.__name__.removeprefix("check_"))
def test_axiom(name, check):
    check(ring(name))
