"""Equal numbers in RR and CC are equal and have equal hashes, in whatever way they are made."""

import itertools
from fractions import Fraction

import sympy

from hfield import H, QuaternionAlgebra
from hfield.fields.names import ring
from tests.subcases import subcases

EQUAL = [
    ("1/6", "(cos(pi/7)-cos(2*pi/7)+cos(3*pi/7))/3", "cos(pi/7)/3-cos(2*pi/7)/3+cos(3*pi/7)/3"),
    ("4/3", "root(20+14*sqrt(2),3)/3+root(20-14*sqrt(2),3)/3", "root(64/27,3)"),
    ("28/11", "root(20+14*sqrt(2),3)*7/11+root(20-14*sqrt(2),3)*7/11"),
    ("1", "root(2,3)*root(4,3)/2", "cos(pi/5)*2*(sqrt(5)-1)/2"),
    ("0", "sqrt(2)+sqrt(3)-sqrt(5+2*sqrt(6))", "root(2,3)-root(2,3)"),
    ("sqrt(2)", "2*cos(pi/4)", "root(4,4)", "root(2,4)^2", "root(8,3)*sqrt(2)/2"),
    ("sqrt(2)+sqrt(3)", "sqrt(5+2*sqrt(6))", "1/(sqrt(3)-sqrt(2))"),
    ("root(2,3)", "root(16,3)/2", "2/root(4,3)", "root(4,6)"),
    ("2*cos(2*pi/7)", "-1-2*cos(4*pi/7)-2*cos(6*pi/7)"),
    ("(1+sqrt(5))/2", "2*cos(pi/5)", "1/(2*cos(2*pi/5))"),
    ("pi+1", "1+pi", "(pi^2-1)/(pi-1)"),
    ("1/3+1/10^30", f"{10**30 + 3}/{3 * 10**30}"),
]  # fmt: skip


@subcases("name", ["RR", "CC"])
@subcases("texts", EQUAL)
def test_equal_numbers(name, texts):
    F = ring(name)
    A = H(F)
    made = [F(text) for text in texts]
    made += [F(text) + F("root(3,5)") - F("root(3,5)") for text in texts]
    for x, y in itertools.product(made, repeat=2):
        assert x == y
        assert F.equal(x, y)
        assert hash(x) == hash(y)
        assert F.key(x) == F.key(y)
    quaternions = [A(0, x, 1, x) for x in made]
    assert len(set(quaternions)) == 1
    assert len({F.key(q.norm()) for q in quaternions}) == 1
    assert len({QuaternionAlgebra(F, x, -1) for x in made}) == 1


def test_rational_numbers_hash_as_those_of_other_libraries():
    F = ring("RR")
    x = F("cos(pi/7)/3-cos(2*pi/7)/3+cos(3*pi/7)/3")
    for y in (Fraction(1, 6), ring("QQ")("1/6")):
        assert x == y
        assert hash(x) == hash(y)
    hidden = F("cos(1)^2+sin(1)^2")
    for y in (1, F(1), Fraction(1), sympy.Integer(1)):
        assert hidden == y
        assert hash(hidden) == hash(y)


def test_numbers_that_are_near_are_different():
    F = ring("RR")
    sixth = "cos(pi/7)/3-cos(2*pi/7)/3+cos(3*pi/7)/3"
    near = ["1/6", "1/6+10^(-60)", f"{sixth}+10^(-50)", "root(2,3)-root(2,3)+1/6+10^(-40)"]
    for x, y in itertools.combinations(map(F, near), 2):
        assert x != y
        assert F.key(x) != F.key(y)
