"""Compiled statements against the evaluator that walks the tree."""

import random

import pytest

from hfield.proving.counterexamples.candidates import holds, small_scalars
from hfield.proving.evaluation.compiled import compile_statement
from hfield.proving.evaluation.interpretation import PrimeInterpretation, RingInterpretation, bind
from hfield.proving.polynomials.vanishing import constant
from hfield.proving.statements.language import Sort, read_statement
from hfield.proving.statements.setting import HAMILTON
from hfield.rings import ring
from hfield.syntax import parse
from tests.adversary.statement_generator import plain_statements

WRITTEN = (
    "q*inv(q) == e",
    "not (1/s == s) <=> s**-2 == 1 or norm(q) == 1/2",
    "p**0 == e and p**-1*p == 1 => comm(p, q) == q - q",
    "conj(p)[2] == -p[2] and vector(p) == p - scalar(p) and trace(k*p) == -2*p[3]",
    "s*p == p*s and 0.5*p + 0.5*p == p",
    "p/norm(p) != 0",
)
DRAWN = tuple(plain_statements(0, 60))


def places(statement, scalars, rng):
    for _ in range(12):
        yield {
            name: rng.choice(scalars)
            if sort is Sort.SCALAR
            else tuple(rng.choice(scalars) for _ in range(4))
            for name, sort in statement.unknowns
        }


def agree(text, field, world, scalars):
    statement = read_statement(text, field)
    fixed = {c: constant(field, c) for c in statement.constants} if field else {}
    bind(world, map(parse, HAMILTON), fixed)
    compiled = compile_statement(statement, world, fixed)
    for place in places(statement, scalars, random.Random(text)):
        world.values = {**fixed, **place}
        assert compiled(place) is holds(world, statement), (text, place)


@pytest.mark.parametrize("text", [*WRITTEN, *DRAWN])
def test_over_prime_fields(text):
    for p in (0, 2, 3, 7):
        agree(text, None, PrimeInterpretation(p), range(p or 4))


@pytest.mark.parametrize("name", ["GF(4)", "GF(2)(t)", "QQ(sqrt(2))"])
def test_over_other_rings(name):
    field = ring(name)
    own = (f"{field.gen_name}*p == p*{field.gen_name}", f"1/{field.gen_name} != q[0]")
    for text in (*own, *WRITTEN, *DRAWN[:20]):
        agree(text, field, RingInterpretation(field), small_scalars(field)[:5])
