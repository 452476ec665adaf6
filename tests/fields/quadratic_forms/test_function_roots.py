"""Square roots over function fields: those that are there are found, the others are proved away."""

import itertools
import random
import sys

import pytest

from hfield import H, QuaternionAlgebra
from hfield.errors import NotFiniteError
from hfield.fields.names import ring
from tests.subcases import subcases

NONE = [
    ("(-1,-1|QQ(x))", ["x", "-x", "-x^2-7", "-x^2-x-1", "-7", "-x^4-7", "-(x^2+3)^3", "1/(x+1)"]),
    ("(x,x+1|QQ(x))", ["x^3+1", "2", "x^2+x"]),
    ("(x,-3|QQ(x))", ["2", "5*x", "x^2+1", "-x^2-3"]),
    ("(x^2-2,3|QQ(x))", ["x", "5*x^2-10", "-1", "7*x^2+3"]),
]  # fmt: skip
SOME = [
    ("(-1,-1|QQ(x))", ["-x^2-1", "-x^2-2", "-2*x^2-3", "x^2", "-x^4-3", "-(x^2+1)/(x^2+5)"]),
    ("(x,x+1|QQ(x))", ["x", "4*x", "x*(x+1)^2", "2*x+1", "-1", "4*x+9*(x+1)-x*(x+1)"]),
    ("(x,-3|QQ(x))", ["x-3", "-3*x^2+x"]),
    ("(x^2-2,3|QQ(x))", ["x^2+1", "3"]),
    ("(t,t+1|GF(5)(t))", ["1", "t^3+t+1", "2*t+3"]),
    ("(t,t+1|GF(2)(t))", ["t^3+t+1", "t^2+1"]),
    ("(t,x|GF(9)(t))", ["t", "x*t^2", "t+x"]),
]  # fmt: skip


@pytest.mark.parametrize(("algebra", "texts"), NONE)
def test_no_square_roots(algebra, texts):
    A = QuaternionAlgebra.from_text(algebra)
    for text in texts:
        assert not A(text).square_roots(), text
        assert list(A(text).square_roots()) == []


@pytest.mark.parametrize(("algebra", "texts"), SOME)
def test_square_roots(algebra, texts):
    A = QuaternionAlgebra.from_text(algebra)
    for text in texts:
        roots = A(text).square_roots()
        assert roots, text
        assert all(x * x == A(text) for x in roots)


def polynomial(F, rng, degree):
    return F("+".join(f"({rng.randint(-3, 3)})*x^{n}" for n in range(degree + 1)))


def test_squares_of_random_elements_have_roots():
    """What is proved to have no root must not be a square."""
    F, rng = ring("QQ(x)"), random.Random(4)
    tried = 0
    while tried < 40:
        a, b = polynomial(F, rng, rng.choice([0, 0, 1, 2])), polynomial(F, rng, rng.choice([0, 1]))
        if F.is_zero(a) or F.is_zero(b):
            continue
        A = QuaternionAlgebra(F, a, b)
        q = A(0, *(polynomial(F, rng, rng.choice([0, 1])) for _ in "ijk"))
        roots = (q * q).square_roots()
        assert roots
        assert q in roots
        assert all(x * x == q * q for x in roots)
        tried += 1


def test_whole_quadrics_over_large_finite_fields():
    for name in ("GF(2305843009213693951)", "GF(3^40)", "GF(2^61)"):
        A = H(name)
        for s in (A(-1), A.zero, A.random_element(1).norm()):
            s = A(s)
            roots = s.square_roots()
            first = list(itertools.islice(roots, 6))
            assert len(set(first)) == 6
            assert all(x * x == s for x in first)
            assert "SquareRoots(" in repr(roots)
            assert A.count(square=s.scalar_part) > sys.maxsize
            with pytest.raises(NotFiniteError, match="too many for len"):
                len(roots)


@subcases(
    "text",
    ["(-1,-1|GF(3))", "[1,1|GF(2))", "[x,1|GF(4))", "(2,3|GF(5))", "(0,0|GF(3))", "(0,2|GF(5))",
     "(1,1|GF(4))", "[1,0|GF(2))", "[1,2|GF(7))", "[0,0|GF(3))"],
)  # fmt: skip
def test_all_square_roots_of_scalars_by_exhaustion(text):
    A = QuaternionAlgebra.from_text(text)
    squares = {}
    for x in A.elements():
        squares.setdefault(x * x, set()).add(x)
    for s in A.ring.elements():
        roots = A(s).square_roots()
        found = list(roots)
        assert len(found) == len(set(found)) == len(roots)
        assert set(found) == squares.get(A(s), set())


def test_degenerate_quadrics_over_large_finite_fields():
    name = "GF(2305843009213693951)"
    for a, b, t, s in ((0, 1, 0, 4), (3, 0, 0, 12), (0, 0, 0, 0), (0, 2, 1, 1), (0, 7, 0, 0)):
        A = QuaternionAlgebra(name, a, b, t)
        first = list(itertools.islice(A(s).square_roots(), 8))
        assert len(set(first)) == 8
        assert all(x * x == s for x in first)
    some = list(itertools.islice(H(name).elements(), 3))
    assert [q.coordinates[3] for q in some] == [0, 1, 2]


def test_lists_of_infinitely_many_roots():
    roots = H("QQ")(-1).square_roots()
    assert not roots.is_finite
    found = list(roots)  # one and its negative
    assert len(found) == 2
    assert sorted(map(str, roots)) == sorted(map(str, found))
    with pytest.raises(NotFiniteError, match="infinitely many"):
        len(roots)
    with pytest.raises(OverflowError):
        len(roots)
