"""Every ring and every algebra over it through the same axioms.

A ring joins by a line in ``RINGS``; a user's own ring may call ``check_all`` of
``tests/fields/axioms.py`` and ``check_algebra`` from its own tests.
"""

from collections.abc import Callable
from random import Random

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from hfield import Quaternion, QuaternionAlgebra, ring
from hfield.errors import NotInvertibleError
from tests.fields.axioms import CHECKS
from tests.subcases import slow, subcases
from tests.thorough import cases

RINGS = (
    "QQ", "ZZ", "RR", "CC", "RDF", "CDF",
    "ZZ/2", "ZZ/6", "ZZ/7", "ZZ/8", "ZZ/100", "ZZ/100000000000000000041", f"ZZ/{3 * 2**70}",
    "GF(2)", "GF(7)", "GF(100000000000000000039)", "GF(9223372036854775783)",
    "GF(4)", "GF(9)", "GF(256)", "GF(9, x^2+1)", "GF(16, x^4+x^3+1)",
    "GF(2^100)", "GF(100000000000000000039^2)",
    "QQ(sqrt(2))", "QQ(sqrt(5))", "QQ(sqrt(30))", "QQ(I)", "QQ(sqrt(-2))", "QQ(sqrt(-3))",
    "QQ(sqrt(-7))", "QQ(sqrt(-163))",
    "QQ[s]/(s^3-2)", "QQ[x]/(x^2-3/2)", "QQ(sqrt(2),sqrt(3))", "QQ(zeta5)", "QQ(zeta7)+",
    "QQ(root(2,3),zeta3)",
    "QQ(x)", "QQ(t)", "GF(2)(t)", "GF(5)(t)", "GF(4)(t)", "GF(9, x^2+1)(t)",
    "GF(100000000000000000039)(t)", "GF(7)(x)",
    "Qp(2)", "Qp(3)", "Qp(5)", "QQ(I)_(5, I-2)", "QQ(sqrt(2))_(2)", "QQ(sqrt(5))_(2)",
    "QQ(sqrt(-7))_(2, sqrt(-7)-3)",
    "QQ[s]/(s^3-2)_(2, s)", "QQ(zeta5)_(5, 4+zeta5)",
    "GF(2)((t))", "GF(9)((t))", "GF(3)(t)_(t^2+1)", "GF(4)(t)_inf",
    "QQ(x,y)", "GF(5)(s,t)", "GF(4)(s,t)", "GF(2)(x,y,z)", "GF(100000000000000000039)(x,y)",
    "GF(3)(t)[u]/(u^2+2*t^3+t)", "QQ(x)[u]/(u^3-x)", "QQ(x,y)[z]/(z^2-x-y)", "GF(9)(t)[u]/(u^2-t)",
    "QQ(sqrt(2))(x)", "QQ(zeta5)(x,y)", "QQ[s]/(s^3-2)(x)", "QQ(sqrt(2),I)[x,y]", "QQ(I)[x]",
    "QQ(cos(t),sin(t))", "QQ(x,cos(t/2),sin(t/2))", "QQ(cos(t),sin(t),cos(u),sin(u))",
    "GF(7)(cos(t),sin(t))", "QQ(I)(cos(t),sin(t))", "RR(cos(t),sin(t))", "RR(x,cos(t/2),sin(t/2))",
    "QQ[x]/(x^2)", "ZZ[I]", "ZZ[x]/(x^2-5)", "QQ[x]/(x^3-x)", "GF(5)[x]/(x^2)",
    "ZZ[a,b,c]", "QQ[x,y]", "GF(5)[x,y]", "QQ[x]", "GF(2)[x,y]", "GF(100000000000000000039)[x,y]",
    "ZZ[a_1,b2,alpha,w,z]",
)  # fmt: skip
# a, b, t: Hamilton, general, degenerate, Artin–Schreier, anything.
# The axioms of an algebra over these take between half a second and five seconds.
SLOW = {
    *("QQ(zeta5)(x,y)", "RR(cos(t),sin(t))", "RR(x,cos(t/2),sin(t/2))"),
    *("QQ(x,y)[z]/(z^2-x-y)", "QQ(x)[u]/(u^3-x)"),
}
COMPILED = {"GF(256)", "GF(16, x^4+x^3+1)"}  # galois compiles its arithmetic for each field
CONSTANTS = [(-1, -1, 0), (2, 3, 0), (0, 1, 0), (0, 0, 0), (1, 1, 1), (5, -2, 3)]


def elements(A: QuaternionAlgebra, seeds: tuple[int, int, int]) -> list[Quaternion]:
    """Three random elements of A; hypothesis shrinks the seeds."""
    return [A.random_element(seed) for seed in seeds]


def check_algebra(A: QuaternionAlgebra, seeds: tuple[int, int, int]) -> None:
    """The axioms of an associative algebra with standard involution, on three elements."""
    p, q, r = elements(A, seeds)
    e, i, j, k = A.basis
    s = A.ring.random(Random(seeds[0]))
    a, t, b = A.constants
    assert (i * i, j * j, i * j, j * i) == (a + t * i, A(b), k, t * j - k)
    assert e * q == q == q * e
    assert (p * q) * r == p * (q * r)
    assert p * (q + r) == p * q + p * r
    assert (p + q) * r == p * r + q * r
    assert (s * p) * q == s * (p * q) == p * (s * q)
    assert p + q == q + p
    assert p - p == 0 == 0 * p
    assert (p * q).conjugate() == q.conjugate() * p.conjugate()
    assert q.conjugate().conjugate() == q
    assert q * q.conjugate() == q.norm() == q.conjugate() * q
    assert q + q.conjugate() == q.trace()
    assert A.ring.equal((p * q).norm(), p.norm() * q.norm())
    assert q * q - q.trace() * q + q.norm() == 0
    assert q**3 == q * q * q
    assert A(*q.coordinates) == q
    assert A.parse(str(q)) == q
    if A.ring.is_exact:
        assert hash(q) == hash(A(*q.coordinates))
    for x in (q, A(s)):
        inverse = _inverse(x)
        assert x.is_unit() == (inverse is not None)
        assert inverse is None or x * inverse == 1 == inverse * x
    y = q.annihilator()
    if y is not None:
        assert y != 0
        assert q * y == 0
        assert q.is_zero_divisor()
        assert not q.is_unit() or A.ring.characteristic == 1


def _inverse(x: Quaternion) -> Quaternion | None:
    try:
        return x.inverse()
    except NotInvertibleError:
        return None


@pytest.mark.parametrize("name", [slow(name) if name in COMPILED else name for name in RINGS])
@subcases("check", CHECKS)
def test_rings(name: str, check: Callable[..., None]) -> None:
    check(ring(name))


@pytest.mark.parametrize(
    "name",
    [slow(name) if name in SLOW else name for name in RINGS if ring(name).is_exact],
)
@settings(
    max_examples=cases(10), deadline=None, suppress_health_check=list(HealthCheck), derandomize=True
)
@given(seeds=st.tuples(*[st.integers(0, 999)] * 3), constants=st.sampled_from(CONSTANTS))
def test_algebras(name: str, seeds: tuple[int, int, int], constants: tuple[int, int, int]) -> None:
    a, b, t = constants
    check_algebra(QuaternionAlgebra(ring(name), a, b, t), seeds)


@pytest.mark.parametrize("constants", CONSTANTS)
def test_the_axioms_can_fail(constants: tuple[int, int, int]) -> None:
    """A product with one term dropped is caught."""
    a, b, t = constants
    A = QuaternionAlgebra(ring("QQ"), a, b, t)

    class Broken(Quaternion):
        def __mul__(self, other: object) -> Quaternion:
            good = Quaternion.__mul__(self, other)
            w, x, y, z = good.coordinates
            return Quaternion(self.algebra, (w, x, y, z + self.coordinates[1]))

    A.__dict__["basis"] = tuple(Broken(A, q.coordinates) for q in A.basis)
    with pytest.raises(AssertionError):
        check_algebra(A, (1, 2, 3))
