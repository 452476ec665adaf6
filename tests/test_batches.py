"""Arrays of quaternions over every kind of ring: pickled, copied, divided, made of truth values."""

import copy
import pickle

import numpy as np
import pytest

from hfield import H, ring
from hfield.errors import CoercionError, HFieldError, NotInvertibleError
from tests.subcases import subcases

RINGS = [
    "ZZ", "ZZ/4", "ZZ/6", "ZZ/100000000000000000000", "QQ", "QQ(sqrt(5))", "QQ(I)", "RR", "CC",
    "GF(2)", "GF(7)", "GF(9)", "GF(9, x^2+1)", "GF(2305843009213693951)", "GF(3^40)",
    "QQ(x)", "GF(2)(t)", "GF(9)(t)", "ZZ[a,b]", "GF(3)[x]", "RDF",
]  # fmt: skip


def gen_or_two(name):
    F = ring(name)
    return F(2) if F.gen_name is None else F.gen


@subcases("name", RINGS)
def test_arrays_pickle_and_copy(name):
    A = H(name)
    x = gen_or_two(name)
    for q in (
        A([0, 1, x], x, [1, x, x * x], 0),
        A([[0, 1, x]], x, 1, 0),
        A([], [], [], []),
        A(np.zeros((0, 3), dtype=int), 0, 0, 0),
        A(1, x, 0, 0),
    ):
        for again in (pickle.loads(pickle.dumps(q)), copy.deepcopy(q), copy.copy(q)):
            assert again.shape == q.shape
            assert again.algebra == q.algebra
            assert type(again.coordinates[0]) is type(q.coordinates[0])
            assert np.all(again == q)
            assert np.all(again * q == q * q)


@subcases("name", RINGS)
def test_dividing_by_zero_names_the_entry(name):
    A = H(name)
    q = A([1, 1, 1], 0, 0, 0)
    zero_at_one = A([1, 0, 1], 0, 0, 0)
    for divide in (lambda: q / 0, lambda: q / A.zero, lambda: q / A(np.array(0), 0, 0, 0)):
        with pytest.raises(NotInvertibleError, match="cannot invert 0"):
            divide()
    for divide in (lambda: q / zero_at_one, lambda: 1 / zero_at_one, lambda: zero_at_one**-1):
        with pytest.raises(NotInvertibleError, match=r"at index \(1,\) of the array"):
            divide()
    with pytest.raises(NotInvertibleError, match=r"at index \(1, 2\) of the array"):
        q / A([[1, 1, 1], [1, 1, 0]], 0, 0, 0)
    assert np.all(q / A.one == q)
    assert np.all(A.one / q == q)
    assert (A([], [], [], []) / 1).shape == (0,)


@subcases("name", RINGS)
def test_truth_values_are_0_and_1_in_every_ring(name):
    A = H(name)
    flags = np.array([True, False])
    expected = A([1, 0], 1, 0, 1)
    for q in (
        A(flags, True, np.False_, np.True_),
        A([True, False], 1, [False, False], np.array(True)),
        A(flags.astype(object), 1, 0, 1),
    ):
        assert np.all(q == expected)
    assert np.all(A(1, 1, 0, 1) * flags == A([1, 0], [1, 0], 0, [1, 0]))
    assert A(np.True_, 0, 0, 0) == 1


def test_arrays_without_dimensions():
    for name in RINGS:
        A = H(name)
        q = A(np.array(1), [1, 0], np.array(0), 1)
        assert q.shape == (2,)
        assert q[0] == A(1, 1, 0, 1)
        with pytest.raises(HFieldError):
            A([1, 0], [1, 2, 3], 0, 0)


@subcases("name", RINGS)
def test_arrays_that_do_not_fit_are_refused(name):
    A = H(name)
    q = A([1, 0, 1], 0, 0, 0)
    other = A([1, 1], 0, 0, 0)
    for combine in (
        lambda: q + other, lambda: q - other, lambda: q * other, lambda: q / other,
        lambda: q == other, lambda: q * np.array([1, 2]), lambda: np.array([1, 2]) - q,
    ):  # fmt: skip
        with pytest.raises(CoercionError, match=r"shapes \(\d,\) and \(\d,\)"):
            combine()
    assert (q * A([[1], [1]], 0, 0, 0)).shape == (2, 3)
    assert q.is_zero().tolist() == [False, True, False]
    assert A([], 0, 0, 0).is_zero().shape == (0,)


@pytest.mark.parametrize("name", ["GF(7)", "GF(9)", "ZZ", "QQ", "QQ(x)"])
def test_without_a_dimension_there_is_one_element(name):
    A = H(name)
    p = A([1, 2], 3, 4, 5)
    assert p[:1].reshape(()) == A(1, 3, 4, 5)
    assert p[:1].reshape(()).shape == ()
    assert p.reshape((2, 1)).shape == p.reshape(2, 1).shape == (2, 1)
    with pytest.raises(CoercionError, match="has no shape"):
        p.reshape("x")
    if name != "QQ(x)":
        q = A.from_array(p.to_array()[..., 0])
        assert str(q) == str(A(1, 3, 4, 5))
        assert q in {A(1, 3, 4, 5)}
