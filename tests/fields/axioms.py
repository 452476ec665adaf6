"""What every base ring must satisfy, ours or a user's: one function for each promise of the protocol.

``check_all(F)`` runs them all; each draws elements by hypothesis and fails with the smallest example.
"""

import pickle
from collections.abc import Callable
from fractions import Fraction
from itertools import islice, product
from random import Random
from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from hfield.errors import CoercionError, HFieldError, NotInvertibleError, RingError, UndecidedError
from hfield.fields import CDF, INFINITY, Ring
from hfield.fields.base.checking import AXIOMS
from hfield.fields.names import ring
from tests.thorough import cases

EXAMPLES = cases(40)
SMALL = 300  # rings of up to so many elements are run through


def elements(F: Ring) -> st.SearchStrategy[Any]:
    """Small multiples of 1, what the names of F stand for, and random elements."""
    named = [F(x) for x in F.names().values()]
    near = st.integers(-3, 3).map(F)
    drawn = st.integers(0, 2**20).map(lambda seed: F.random(Random(seed)))
    return st.one_of(near, drawn, st.sampled_from(named)) if named else st.one_of(near, drawn)


def for_all(F: Ring, count: int, check: Callable[..., None], examples: int = EXAMPLES) -> None:
    """Run ``check`` on ``count`` elements of F, ``examples`` times."""
    x = elements(F)

    @settings(
        max_examples=examples,
        deadline=None,
        database=None,
        derandomize=True,
        suppress_health_check=list(HealthCheck),
    )
    @given(st.tuples(*[x] * count))
    def run(values: tuple[Any, ...]) -> None:
        check(*values)

    run()


def check_ring_axioms(F: Ring) -> None:
    """Addition and multiplication are those of a commutative ring with 1."""

    def run(*values: Any) -> None:
        for axiom in AXIOMS:
            assert axiom.holds(F, *values[: axiom.count]), axiom.text

    for_all(F, 3, run)


def check_coercion(F: Ring) -> None:
    """Integers are multiples of 1, Fractions quotients, elements themselves; anything else is refused."""

    def run(x: Any) -> None:
        assert F.equal(F(x), x)

    for_all(F, 1, run, 5)
    five = F.one + F.one + F.one + F.one + F.one
    assert F.equal(F(5), five)
    assert F.equal(F(-5), -five)
    assert F.equal(F(np.int64(5)), five)
    assert F.equal(F(np.uint8(5)), five)
    assert F.equal(F(True), F.one)
    assert F.equal(F(" 2 + 3 "), five)
    assert F.equal(F("−5"), -five)
    assert F.equal(F(10**30), F(10**15) * F(10**15)) or not F.is_exact
    try:
        third = F(Fraction(1, 3))
    except HFieldError:
        assert not F.is_unit(F(3))
    else:
        assert F.agree(third + third + third, F.one)
    complex_number = () if F == CDF else (1j,)
    for junk in (
        None,
        [1],
        (1, 2),
        {},
        object(),
        b"1",
        *complex_number,
        float("nan"),
        float("inf"),
    ):
        with pytest.raises(CoercionError, match="is not an element of"):
            F(junk)
    for text in ("", "1+", "__import__('os')", "foo", "1 == 1", "1(2)", "1/0"):
        with pytest.raises(HFieldError):
            F(text)
    if F.is_exact:
        with pytest.raises(CoercionError, match="not exact"):
            F(0.5)
        with pytest.raises(CoercionError):
            F(np.float32(0.5))


def check_characteristic(F: Ring) -> None:
    """``characteristic`` is the additive order of 1."""
    p = F.characteristic
    if p == 0:
        assert all(not F.is_zero(F(n)) for n in (1, 2, 3, 5, 7, 30, 2**31 - 1))
    else:
        assert F.is_zero(F(p))
        assert all(not F.is_zero(F(n)) for n in range(1, min(p, 50)))
        assert not F.is_zero(F(p - 1))


def check_units(F: Ring) -> None:
    """Units have inverses; what has none says so; annihilators annihilate; a field has only units."""

    def run(x: Any, y: Any) -> None:
        killer = F.annihilator(x)
        assert killer is None or (not F.is_zero(killer) and F.is_zero(x * killer))
        if F.is_unit(x):
            assert killer is None
            assert F.agree(x * F.inverse(x), F.one)
            assert F.agree(F.divide(y, x) * x, y)
            assert F.agree(F.power(x, -2) * x * x, F.one)
        else:
            assert F.is_zero(x) or not F.is_field
            assert killer is not None or F.order is None
            with pytest.raises(NotInvertibleError):
                F.inverse(x)
        assert F.agree(F.power(x, 3), x * x * x)
        assert F.agree(F.power(x, 0), F.one)

    for_all(F, 2, run)
    assert not F.is_unit(F.zero)
    assert F.annihilator(F.zero) is not None
    with pytest.raises(NotInvertibleError):
        F.inverse(F.zero)
    with pytest.raises(NotInvertibleError):
        F.divide(F.one, F.zero)
    with pytest.raises(ZeroDivisionError):
        F.power(F.zero, -1)


def check_text(F: Ring) -> None:
    """Plain and unicode texts read back; LaTeX is there; names and the generator are readable."""

    def run(x: Any) -> None:
        for style in ("plain", "unicode"):
            text = F.text(x, style)
            assert isinstance(text, str)
            assert F.equal(F(text), x), text
        assert " " not in F.text(x)
        assert F.text(x, "latex").count("{") == F.text(x, "latex").count("}")

    for_all(F, 1, run)
    if F.gen_name is not None:
        assert F.equal(F(F.gen_name), F.gen)
        assert F.text(F.gen) == F.gen_name
    else:
        with pytest.raises(UndecidedError):
            F.gen  # noqa: B018
    for name, x in F.names().items():
        assert F.equal(F(name), x)


def check_keys(F: Ring) -> None:
    """Keys are hashable, and equal exactly where the elements are."""

    def run(x: Any, y: Any) -> None:
        assert (F.key(x) == F.key(y)) == F.equal(x, y)
        again = F(F.text(x)) if F.is_exact else x
        assert F.key(again) == F.key(x)
        assert hash(F.key(again)) == hash(F.key(x))
        detour = (x + y) - y
        assert not F.is_exact or hash(F.key(detour)) == hash(F.key(x))

    for_all(F, 2, run)


def check_elements(F: Ring) -> None:
    """A finite ring runs through its elements, 0 and 1 first, lazily and each once."""
    if F.order is None:
        with pytest.raises(TypeError, match="infinite"):
            F.elements()
        return
    first = list(islice(F.elements(), 2))
    assert F.is_zero(first[0])
    assert F.equal(first[1], F.one)
    if F.order <= SMALL:
        assert len({F.key(x) for x in F.elements()}) == len(list(F.elements())) == F.order


def check_random(F: Ring) -> None:
    """The same seed gives the same element, and not all seeds the same."""
    drawn = [F.random(Random(seed)) for seed in range(20)]
    assert all(F.equal(x, F.random(Random(seed))) for seed, x in enumerate(drawn))
    assert len({F.key(x) for x in drawn}) > 1


def check_sqrt(F: Ring) -> None:
    """A root squares back, squares have roots; over a small ring ``None`` is right, too."""
    try:
        F.sqrt(F.one + F.one)
    except UndecidedError:
        return  # a ring need not know its squares, but has to say so

    def run(x: Any) -> None:
        try:
            root, of_square = F.sqrt(x), F.sqrt(x * x)
        except UndecidedError:
            return
        assert root is None or F.agree(root * root, x)
        assert of_square is not None
        assert F.agree(of_square * of_square, x * x)

    for_all(F, 1, run)
    if F.order is not None and F.order <= SMALL:
        squares = {F.key(x * x) for x in F.elements()}
        assert all((F.sqrt(x) is not None) == (F.key(x) in squares) for x in F.elements())


def check_level(F: Ring) -> None:
    """The level has a reason, as many squares as it says add up to −1, and fewer do not."""
    level, squares = F.level, F.minus_one_as_squares()
    assert level.reason
    assert str(level)
    if level.value is None:
        assert squares == ()
        return
    if level.value == INFINITY:
        assert squares == ()
        assert F.orderings.value is None or F.orderings.value > 0
        return
    assert len(squares) == level.value
    assert F.orderings.value == 0
    assert F.vanishes(sum((y * y for y in squares), F.one))
    if F.order is not None and F.order <= SMALL:
        values = {F.key(x * x): x * x for x in F.elements()}.values()
        for count in range(1, level.value):
            sums = product(values, repeat=count)
            assert all(not F.is_zero(sum(parts, F.one)) for parts in islice(sums, 20_000))


def check_sign(F: Ring) -> None:
    """Signs are those of orderings: multiplicative, additive on the positive, 0 only for 0."""
    known = F.orderings.value
    if known is None or known == 0:
        if known == 0:
            with pytest.raises(RingError):
                F.sign(F.one)
        return
    count = 1 if known == INFINITY else known

    def run(x: Any, y: Any) -> None:
        for n in range(count):
            sx, sy = F.sign(x, n), F.sign(y, n)
            assert sx in (-1, 0, 1)
            assert (sx == 0) == F.is_zero(x)
            assert F.sign(x * y, n) == sx * sy
            assert F.sign(-x, n) == -sx
            if sx == sy:
                assert F.sign(x + y, n) == sx

    for_all(F, 2, run)
    with pytest.raises(RingError):
        F.sign(F.one, -1)
    if known != INFINITY:
        with pytest.raises(RingError):
            F.sign(F.one, known)


def check_arrays(F: Ring) -> None:
    """Arrays compute elementwise, broadcast with 0-dimensional ones, and give elements back."""
    rng = Random(1)
    xs, ys = ([F.random(rng) for _ in range(4)] for _ in range(2))
    a, b, c = F.array(xs), F.array(ys), F.array(xs[0])
    assert a.shape == b.shape == (4,)
    assert c.shape == ()
    assert F.equal(F.scalar(c[()]), xs[0])
    assert F.array([xs, ys]).shape == (2, 4)
    assert F.array([]).shape == (0,)
    operations: list[Callable[[Any, Any], Any]] = [
        lambda x, y: x + y,
        lambda x, y: x - y,
        lambda x, y: x * y,
        lambda x, y: x * y + y * x - x,
        lambda x, y: -x,
    ]
    for f in operations:
        _matches(F, f(a, b), [f(x, y) for x, y in zip(xs, ys, strict=True)])
        _matches(F, f(a, c), [f(x, xs[0]) for x in xs])
        _matches(F, f(c, b), [f(xs[0], y) for y in ys] if f is not operations[-1] else -xs[0])
        _matches(F, f(c, c) * a, [f(xs[0], xs[0]) * x for x in xs])
        _matches(F, f(c, c), f(xs[0], xs[0]))
    assert np.asarray(a == a, dtype=bool).all()
    assert not np.asarray(a == a + F.array(1), dtype=bool).any()
    assert F.array(np.arange(6).reshape(2, 3)).shape == (2, 3)
    assert F.equal(F.scalar(F.array(np.arange(6))[5]), F(5))
    assert F.array(a).shape == (4,)
    units = F.array_units(a)
    assert units.dtype == bool
    assert units.tolist() == [F.is_unit(x) for x in xs]
    good = a[units]
    assert np.asarray(good * F.array_inverse(good) == F.array(1)).all() or not F.is_exact


def _matches(F: Ring, got: Any, expected: Any) -> None:
    if not isinstance(expected, list):
        assert F.agree(F.scalar(got), expected)
        return
    assert got.shape == (len(expected),)
    assert all(F.agree(F.scalar(got[n]), y) for n, y in enumerate(expected))


def check_identity(F: Ring) -> None:
    """Equal rings are equal by name; pickling keeps that; a ring of ours is what its name says."""
    assert repr(F) == str(F) == F.name
    copy = pickle.loads(pickle.dumps(F))
    assert copy == F
    assert hash(copy) == hash(F)
    assert F != "QQ"
    assert F.in_words()
    assert "\n" not in F.in_words()
    if type(F).__module__.startswith("hfield."):
        assert ring(F.name) == F
        assert ring(" " + F.name.replace(",", " , ")).name == F.name


def check_all(F: Ring) -> None:
    """Run every check."""
    for check in CHECKS:
        check(F)


CHECKS = (
    check_identity,
    check_ring_axioms,
    check_coercion,
    check_characteristic,
    check_units,
    check_text,
    check_keys,
    check_elements,
    check_random,
    check_sqrt,
    check_level,
    check_sign,
    check_arrays,
)
