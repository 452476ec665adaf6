"""The straight-line program is the formula: on symbols of every kind, with every constant put in."""

from itertools import product as tuples

import flint
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from hfield.core.product import Constants
from hfield.core.straight_line import (
    BINARY,
    FIRST,
    FORMULAS,
    GENERAL,
    ONE,
    SECOND,
    _Tape,
    arithmetic_text,
    parts,
    pattern,
    specialise,
    specialise_extension,
)

PATTERNS = [
    Constants(*known)
    for known in tuples(("0", "1", "-1", "a"), ("0", "1", "-1", "t"), ("0", "1", "-1", "b"))
]
INTEGERS = st.integers(-(10**20), 10**20)


def as_tuple(x):
    return x if isinstance(x, tuple) else (x,)


def values_of(numbers, known, make=int):
    """The inputs of a program with these constants, and the constants themselves."""
    values = {n: make(x) for n, x in zip((*FIRST, *SECOND, *GENERAL), numbers, strict=True)}
    constants = Constants(*(values[n] if n in values else make(int(n)) for n in known))
    return values | {ONE: make(1)}, constants


def by_formula(formula, constants, values):
    sides = [FIRST, SECOND] if formula in BINARY else [FIRST]
    return as_tuple(FORMULAS[formula](constants, *(tuple(values[n] for n in s) for s in sides)))


@pytest.mark.parametrize("formula", FORMULAS)
@settings(max_examples=3, deadline=None)
@given(numbers=st.tuples(*[INTEGERS] * 11))
def test_every_pattern_of_constants(formula, numbers) -> None:
    for known in PATTERNS:
        values, constants = values_of(numbers, known)
        program = specialise(formula, known)
        assert program.evaluate(values, 0) == by_formula(formula, constants, values)
        assert not {name for name in known if name not in GENERAL} & set(program.inputs)


@pytest.mark.slow
@pytest.mark.parametrize("formula", FORMULAS)
@given(numbers=st.tuples(*[st.integers(0, 1)] * 11))
def test_characteristic_two(formula, numbers) -> None:
    def make(x):
        return flint.nmod(x % 2, 2)

    for known in PATTERNS:
        values, constants = values_of(numbers, known, make)
        program = specialise(formula, known, 2)
        assert program.evaluate(values, make(0)) == by_formula(formula, constants, values)
        assert {step.operation for step in program.steps} <= {"+", "*"}


@pytest.mark.parametrize("formula", FORMULAS)
@settings(max_examples=20)
@given(numbers=st.tuples(*[INTEGERS] * 11), known=st.sampled_from(PATTERNS))
def test_text(formula, numbers, known) -> None:
    values, constants = values_of(numbers, known)
    assigned, outputs = specialise(formula, known).expressions(arithmetic_text)
    for name, text in assigned:
        values[name] = eval(text, {}, values)
    found = tuple(eval(text, {}, values) for text in outputs)
    assert found == by_formula(formula, constants, values)


def test_text_keeps_the_order_of_the_steps() -> None:
    """Floats round: the text must bracket as the formula does."""
    values = dict(
        zip((*FIRST, *SECOND, *GENERAL), [0.1 * n + 1e8 / 3**n for n in range(11)], strict=True)
    )
    program = specialise("product", GENERAL)
    assigned, outputs = program.expressions(arithmetic_text)
    by_steps = program.evaluate(values, 0.0)
    for name, text in assigned:
        values[name] = eval(text, {}, values)
    assert tuple(eval(text, {}, values) for text in outputs) == by_steps


@pytest.mark.parametrize("formula", FORMULAS)
@pytest.mark.parametrize(
    "relation", [("-1", "0"), ("m_0", "0"), ("m_0", "m_1"), ("m_0", "1", "m_2")]
)
@settings(max_examples=5, deadline=None)
@given(data=st.data())
def test_extensions(formula, relation, data) -> None:
    """Over ℤ[s] modulo a monic polynomial: flint multiplies polynomials and takes remainders."""
    n = len(relation)
    small = st.integers(-99, 99)
    power = [data.draw(small) if name.startswith("m") else int(name) for name in relation]
    modulus = flint.fmpz_poly([-c for c in power] + [1])
    vectors = {
        name: data.draw(st.lists(small, min_size=n, max_size=n))
        for name in (*FIRST, *SECOND, *GENERAL)
    }
    known = tuple(
        ("0",) * n if name == data.draw(st.sampled_from("atbxx")) else parts(name, n)
        for name in GENERAL
    )
    values = {ONE: 1} | dict(zip(relation, power, strict=True))
    for name, vector in vectors.items():
        values |= dict(zip(parts(name, n), vector, strict=True))
    polynomials = {name: flint.fmpz_poly(vector) for name, vector in vectors.items()}
    zero = flint.fmpz_poly([])
    constants = Constants(
        *(zero if c[0] == "0" else polynomials[m] for m, c in zip(GENERAL, known, strict=True))
    )
    expected = [f % modulus for f in by_formula(formula, constants, polynomials)]
    found = specialise_extension(formula, known, relation).evaluate(values, 0)
    assert list(found) == [int(f[k]) for f in expected for k in range(n)]


def test_hamilton_needs_sixteen_products_and_no_constant() -> None:
    program = specialise("product", Constants("-1", "0", "-1"))
    count = [step.operation for step in program.steps]
    assert (count.count("*"), len(count)) == (16, 28)
    assert program.inputs == tuple(sorted(FIRST + SECOND))


def test_nothing_is_computed_twice_or_for_nothing() -> None:
    for known in PATTERNS:
        for formula in FORMULAS:
            program = specialise(formula, known)
            steps = [(op, tuple(sorted(x)) if op in "+*" else x) for _, op, x in program.steps]
            assert len(set(steps)) == len(steps)
            used = {x for step in program.steps for x in step.operands} | set(program.outputs)
            assert all(step.name in used for step in program.steps)


def test_what_is_known_already() -> None:
    tape = _Tape(0)
    assert tape.write("*", "x", "y") == tape.write("*", "y", "x")
    assert tape.write("-", "x", "y") != tape.write("-", "y", "x")


def test_pattern() -> None:
    assert pattern(Constants(6, 0, 3), lambda x, n: (x - n) % 7 == 0) == ("-1", "0", "b")
    assert pattern(Constants(1, 0, 1), lambda x, n: (x - n) % 2 == 0) == ("1", "0", "1")
