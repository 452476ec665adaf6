"""`Rotation` as an array and as a group: shapes, indexing, products, equality, immutability."""

import copy
import pickle
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from hfield import QQ, H
from rotation import DTypeError, Rotation, RotationError
from tests.patience import PATIENCE
from tests.rotation import reference
from tests.rotation.reference import exact, length, mp


def rotations(shape: Any, seed: int = 0) -> Rotation:
    return Rotation.random(shape, rng=seed)


def same(p: Rotation, q: Rotation, atol: float = 1e-14) -> bool:
    return p.shape == q.shape and bool(np.all(p.approx_equal(q, atol=atol)))


# As an array


@pytest.mark.parametrize("shape", [(), (1,), (5,), (2, 3), (0,), (4, 0, 2)])
def test_every_shape(shape: tuple[int, ...]) -> None:
    r = rotations(shape)
    assert (r.shape, r.ndim, r.size) == (shape, len(shape), int(np.prod(shape)))
    assert r.single == (shape == ())
    assert r.as_quat().shape == (*shape, 4)
    assert r.as_matrix().shape == (*shape, 3, 3)
    for vectors in (r.as_rotvec(), r.as_euler("ZYX"), r.as_mrp(), r.as_axis_angle()[0]):
        assert vectors.shape == (*shape, 3)
    assert np.shape(r.magnitude()) == shape
    assert np.shape(r.as_axis_angle()[1]) == shape
    for back in (
        Rotation.from_quat(r.as_quat()),
        Rotation.from_matrix(r.as_matrix()),
        Rotation.from_matrix(r.as_matrix(), orthonormalize=True),
        Rotation.from_rotvec(r.as_rotvec()),
        Rotation.from_euler("ZYX", r.as_euler("ZYX")),
        Rotation.from_axis_angle(*r.as_axis_angle()),
        Rotation.from_mrp(r.as_mrp()),
        r * r * r.inv(),
        (r**0.5) ** 2,
    ):
        assert same(back, r)
    assert r.apply(np.ones((*shape, 3))).shape == (*shape, 3)
    assert (r == r).all() if shape else (r == r) is np.True_


def test_a_single_rotation_is_no_sequence() -> None:
    r = rotations(None)
    for fails in (lambda: len(r), lambda: r[0], lambda: list(r)):
        with pytest.raises(TypeError, match="single rotation"):
            fails()
    assert r


def test_indexing_is_that_of_the_batch() -> None:
    r = rotations((4, 5))
    q = r.as_quat()
    mask = np.zeros((4, 5), bool)
    mask[1, 2] = mask[3, 0] = True
    for index in (
        1,
        -1,
        (1, 2),
        slice(1, 3),
        (slice(None), 2),
        (slice(None, None, -2), slice(1, None)),
        [0, 2],
        ([0, 2], [1, 1]),
        mask,
        mask[:, 0],
        None,
        (None, 1),
        ...,
        (..., 3),
        (2, ...),
        np.array([[0, 1], [2, 3]]),
    ):
        assert np.array_equal(r[index].as_quat(), q[_kept(index)]), index
    for index in ((0, 0, 0), 4, (0, 5), (slice(None), slice(None), 1)):
        with pytest.raises(IndexError):
            r[index]
    assert [x.shape for x in r] == [(5,)] * 4


def _kept(index: Any) -> tuple[Any, ...]:
    """An index for the quaternions themselves: their own axis is kept."""
    index = index if isinstance(index, tuple) else (index,)
    return (*index, slice(None)) if any(i is ... for i in index) else index


def test_concatenate_and_reshape() -> None:
    a, b, c = rotations(3), rotations(None, 1), rotations(2, 2)
    joined = Rotation.concatenate([a, b, c])
    assert joined.shape == (6,)
    assert joined[3] == b
    assert (joined[4:] == c).all()
    assert Rotation.concatenate(a).shape == (3,)
    assert Rotation.concatenate(x for x in a).shape == (3,)
    assert joined.reshape(2, 3).shape == joined.reshape((2, -1)).shape == (2, 3)
    assert joined.reshape(2, 3)[1, 0] == joined[3]
    assert joined[:1].reshape(()).single
    for fails in (
        lambda: Rotation.concatenate([]),
        lambda: Rotation.concatenate([a, 3]),
        lambda: Rotation.concatenate([rotations((2, 2)), rotations((2, 3))]),
        lambda: joined.reshape(4, 2),
        lambda: joined.reshape(4, -1),
    ):
        with pytest.raises(RotationError):
            fails()


def test_identity_and_random() -> None:
    assert Rotation.identity().as_quat().tolist() == [1, 0, 0, 0]
    assert Rotation.identity((2, 3)).shape == (2, 3)
    assert Rotation.random(4).shape == (4,)
    assert (rotations(4, 7) == Rotation.random(4, seed=7)).all()
    assert (rotations(4, 7) == Rotation.random(4, np.random.default_rng(7))).all()
    assert not (rotations(4, 7) == rotations(4, 8)).any()
    for shape in (-1, (2, -1), 1.5, "3"):
        with pytest.raises(RotationError, match="shape"):
            Rotation.random(shape)  # type: ignore[arg-type]


def test_random_rotations_are_uniform() -> None:
    """Of Haar measure the angle has the density (1 − cos θ)/π, and every direction is as likely."""
    r = rotations(200_000, 3)
    for angle in np.linspace(0.5, 3, 6):
        expected = (angle - np.sin(angle)) / np.pi
        assert np.mean(r.magnitude() <= angle) == pytest.approx(expected, abs=5e-3)
    turned = r.apply([0, 0, 1])
    assert np.abs(turned.mean(axis=0)).max() < 5e-3
    assert np.abs(turned.T @ turned / len(r) - np.eye(3) / 3).max() < 5e-3


# As a group


def test_the_right_factor_acts_first() -> None:
    p, q = rotations(None, 1), rotations(None, 2)
    v = np.array([1.0, 2, 3])
    assert (p * q).apply(v) == pytest.approx(p.apply(q.apply(v)), abs=1e-14)
    assert (p * q).as_matrix() == pytest.approx(p.as_matrix() @ q.as_matrix(), abs=1e-14)


def test_batches_broadcast_and_outer_gives_all_pairs() -> None:
    p, q = rotations((4, 1), 1), rotations(3, 2)
    assert (p * q).shape == (4, 3)
    assert (rotations(3) * rotations(None)).shape == (3,)
    pairs = rotations(4, 1).outer(q)
    assert pairs.shape == (4, 3)
    assert same(pairs, p * q)
    assert rotations((2, 3)).outer(rotations((4, 5))).shape == (2, 3, 4, 5)
    assert rotations(None).outer(q).shape == (3,)
    with pytest.raises(RotationError, match="broadcast"):
        rotations(4) * q
    with pytest.raises(RotationError, match="broadcast"):
        rotations(4) == q  # noqa: B015


def test_rational_rotations_are_those_of_hfield() -> None:
    """The exact algebra is the oracle: unit quaternions over the rationals."""
    A = H(QQ)
    rng = np.random.default_rng(4)
    for _ in range(50):
        pair = []
        for _ in range(2):
            n = A(*(int(c) for c in rng.integers(-9, 10, 4)))
            pair.append(n * n / n.norm() if n.norm() else A(1, 0, 0, 0))
        product = [float(Fraction(str(c))) for c in (pair[0] * pair[1]).coordinates]
        p, q = (Rotation([float(Fraction(str(c))) for c in x.coordinates]) for x in pair)
        assert (p * q).as_quat() == pytest.approx(product, abs=1e-15)


@pytest.mark.parametrize("most", [0.5, 3.0, 1000.0, 1e6])
def test_powers_are_as_near_as_documented(most: float) -> None:
    rng = np.random.default_rng(9)
    raw = rng.normal(size=(60, 4)) * 10.0 ** rng.uniform(-6, 0, (60, 4))
    r, exponents = Rotation(raw), rng.uniform(-most, most, 60)
    for row, t, found in zip(r.as_quat(), exponents, (r**exponents).as_quat(), strict=True):
        w, *u = exact(row if row[0] > 0 else -row)
        n = length(u)
        half = mp.atan2(n, w) * mp.mpf(t)
        right = [mp.cos(half), *(mp.sin(half) * x / n for x in u)]
        error = length([a - b for a, b in zip(exact(found), right, strict=True)])
        assert error <= (3 + 2.5 * abs(t)) * 2.0**-52


def test_inverse_and_powers() -> None:
    r = rotations(1000, 5)
    one = Rotation.identity(1000)
    assert (r * r.inv()).magnitude().max() < 1e-15
    assert same(r**2, r * r)
    assert same(r**-3, (r * r * r).inv())
    assert same(r**0, one)
    assert (r**1 == r).all()
    assert (r**-1 == r.inv()).all()
    assert (r**0.25).magnitude() == pytest.approx(r.magnitude() / 4, rel=1e-13)
    assert same(
        r ** np.arange(1000), Rotation.from_rotvec(np.arange(1000)[:, None] * r.as_rotvec()), 1e-11
    )
    assert (rotations((4, 1)) ** np.array([1.0, 2, 3])).shape == (4, 3)
    assert same(Rotation(-r.as_quat()) ** 0.3, r**0.3)  # the sign of a quaternion is nothing
    with pytest.raises(RotationError, match="broadcast"):
        r ** [1.0, 2.0]
    with pytest.raises(DTypeError):
        r ** "2"  # type: ignore[operator]


def test_foreign_operands_are_refused() -> None:
    r = rotations(3)
    for fails in (
        lambda: r * 2,
        lambda: 2 * r,
        lambda: np.ones((3, 3)) * r,
        lambda: r * np.ones(3),
    ):
        with pytest.raises(TypeError):
            fails()
    assert r != 3
    assert (rotations(None) == "x") is False


def test_magnitudes_lie_between_0_and_pi() -> None:
    r = rotations(1000, 6)
    wanted = np.arccos(np.clip((np.trace(r.as_matrix(), axis1=1, axis2=2) - 1) / 2, -1, 1))
    assert r.magnitude() == pytest.approx(wanted, abs=1e-7)
    assert Rotation([0, 1, 0, 0]).magnitude() == np.pi
    assert Rotation([-1, 0, 0, 0]).magnitude() == 0
    assert Rotation([0, 0, 3, 4]).magnitude(degrees=True) == 180


def test_equality_and_hash() -> None:
    r = rotations(5, 7)
    assert (r == Rotation(-r.as_quat())).all()
    assert not (r == r[::-1])[[0, 1, 3, 4]].any()
    assert (r != r[::-1]).tolist() == [True, True, False, True, True]
    assert hash(r[0]) == hash(Rotation(-r[0].as_quat()))
    assert len({r[0], Rotation(-r[0].as_quat()), r[1]}) == 2
    with pytest.raises(TypeError, match="hash"):
        hash(r)


def test_approximate_equality_is_in_angles() -> None:
    r = rotations(None, 8)
    near = r * Rotation.from_rotvec([0, 1e-6, 0])
    assert r.approx_equal(near, atol=1.001e-6)
    assert not r.approx_equal(near, atol=0.999e-6)
    assert not r.approx_equal(near)
    assert r.approx_equal(near, atol=1e-4, degrees=True)
    assert r.approx_equal(Rotation(-r.as_quat()), atol=0 + 1e-15)


# Long products


PLACES = 100  # binary; the factors are given with 62, off by less than a thousandth of an ulp of 1
Fixed = tuple[int, int, int, int]


def exact_product(q: np.ndarray) -> np.ndarray:
    """``q[n]·…·q[0]`` of the floats themselves, in integers."""
    total: Fixed = (1 << PLACES, 0, 0, 0)
    for factor in fixed(q):
        total = fixed_product(factor, total)
    return rounded(total)


def exact_power(q: np.ndarray, exponent: int) -> np.ndarray:
    square = tuple(c << (PLACES - 62) for c in fixed(q))
    power: Fixed = (1 << PLACES, 0, 0, 0)
    while exponent:
        power = fixed_product(power, square, PLACES) if exponent % 2 else power
        square, exponent = fixed_product(square, square, PLACES), exponent // 2
    return rounded(power)


def fixed(q: np.ndarray) -> Any:
    return (q * 2.0**62).astype(np.int64).tolist()


def fixed_product(p: Any, q: Any, places: int = 62) -> Fixed:
    (w, x, y, z), (a, b, c, d) = p, q
    return (
        (w * a - x * b - y * c - z * d) >> places,
        (w * b + x * a + y * d - z * c) >> places,
        (w * c - x * d + y * a + z * b) >> places,
        (w * d + x * c - y * b + z * a) >> places,
    )


def rounded(q: Fixed) -> np.ndarray:
    v = [mp.mpf(n) for n in q]
    return np.array([float(n / reference.length(v)) for n in v])


@pytest.mark.slow
@pytest.mark.slow
@pytest.mark.parametrize("kind", ["random", "one repeated"])
def test_a_million_compositions(kind: str) -> None:
    n = 10**6
    r = rotations(n if kind == "random" else (), 9)
    q = np.broadcast_to(r.as_quat(), (n, 4))
    products = Rotation(q).cumprod().as_quat()
    assert np.abs(np.sqrt((products**2).sum(axis=1)) - 1).max() <= 1e-15
    end, wanted = products[-1], exact_product(q) if kind == "random" else exact_power(q[0], n)
    error = min(np.linalg.norm(end - wanted), np.linalg.norm(end + wanted))
    assert error <= (2e-12 if kind == "random" else 1e-10)


def test_products_one_by_one_do_not_drift() -> None:
    r = list(rotations(5000, 10))
    total = Rotation.identity()
    for x in r:
        total = x * total
    assert abs(np.linalg.norm(total.as_quat()) - 1) <= 1e-15
    wanted = exact_product(np.array([x.as_quat() for x in r]))
    assert total.approx_equal(Rotation(wanted), atol=1e-13)


@pytest.mark.parametrize("shape", [(1,), (2,), (7,), (64,), (65, 3), (0,), (5, 0), (1500,)])
def test_running_products(shape: tuple[int, ...]) -> None:
    r = rotations(shape, 11)
    world, body = r.cumprod(), r.cumprod("body")
    assert world.shape == body.shape == shape
    forwards = backwards = Rotation.identity(shape[1:])
    for n in range(shape[0]):
        forwards, backwards = r[n] * forwards, backwards * r[n]
        assert same(world[n], forwards)
        assert same(body[n], backwards)


def test_running_products_that_cannot_be() -> None:
    with pytest.raises(RotationError, match="single"):
        rotations(None).cumprod()
    with pytest.raises(RotationError, match="frame"):
        rotations(3).cumprod("moon")


# As a Python object


def test_rotations_are_immutable() -> None:
    source = np.array([[1.0, 0, 0, 0], [0, 1, 0, 0]])
    r = Rotation(source)
    source[:] = 9
    assert r.as_quat().tolist() == [[1, 0, 0, 0], [0, 1, 0, 0]]
    for name in ("_q", "shape", "colour"):
        with pytest.raises(AttributeError, match="immutable"):
            setattr(r, name, None)
    with pytest.raises(AttributeError, match="immutable"):
        del r._q
    with pytest.raises(ValueError, match="read-only"):
        r._q[0, 0] = 2.0
    assert not r[0]._q.flags.writeable
    assert not r[[1, 0]]._q.flags.writeable
    with pytest.raises(TypeError):
        r[0] = r[1]  # type: ignore[index]


def test_pickle_and_copy() -> None:
    for r in (rotations(None), rotations((2, 3)), rotations(0)):
        for protocol in range(2, pickle.HIGHEST_PROTOCOL + 1):
            back = pickle.loads(pickle.dumps(r, protocol))
            assert type(back) is Rotation
            assert np.array_equal(back.as_quat(), r.as_quat())
            assert not back._q.flags.writeable
        assert copy.copy(r) is r
        assert copy.deepcopy(r) is r


def test_subclasses_stay_themselves() -> None:
    class Attitude(Rotation):
        pass

    a = Attitude.random(3, rng=1)
    for r in (a, a[0], a.inv(), a * a, a**2, a.mean(), a.cumprod(), pickle_free(a)):
        assert type(r) is Attitude


def pickle_free(r: Rotation) -> Rotation:
    return copy.deepcopy(r)


def test_the_text_reads_back() -> None:
    for r in (Rotation.identity(), Rotation([[0, 1, 0, 0], [0, 0.6, 0.8, 0]])):
        again = eval(repr(r), {"Rotation": Rotation})
        assert np.all(again == r)
    assert repr(Rotation.identity()) == "Rotation.from_quat([1., 0., 0., 0.])"
    assert len(repr(rotations(10**6))) < 1000


def test_threads_share_rotations() -> None:
    r, v = rotations(20_000, 12), np.random.default_rng(13).standard_normal((20_000, 3))

    def work(_: int) -> np.ndarray:
        return (r * r.inv() * r).apply(v)

    with ThreadPoolExecutor(4) as pool:
        results = list(pool.map(work, range(8)))
    assert all(np.array_equal(x, results[0]) for x in results)


@given(st.lists(st.floats(allow_nan=True), min_size=4, max_size=4))
def test_every_quaternion_is_a_rotation_or_nan_or_an_error(q: list[float]) -> None:
    if not any(q):
        with pytest.raises(RotationError):
            Rotation.from_quat(q)
        return
    found = Rotation.from_quat(q).as_quat()
    if np.isfinite(q).all():
        assert abs(np.linalg.norm(found) - 1) <= 1e-15
    else:
        assert np.isnan(found).all()


@pytest.mark.slow
def test_imports_are_light() -> None:
    code = (
        "import sys, rotation; rotation.Rotation, rotation.slerp, rotation.integrate, rotation.align\n"
        "rotation.Rotation.from_euler('xyz', [1, 2, 3]).as_matrix()\n"
        "heavy = {'numba', 'scipy', 'matplotlib', 'sympy', 'galois', 'flint'} & set(sys.modules)\n"
        "sys.exit(str(heavy) if heavy else 0)"
    )
    subprocess.run([sys.executable, "-c", code], check=True, timeout=PATIENCE)
    import rotation

    assert set(rotation.__all__) <= set(dir(rotation))
    assert all(getattr(rotation, name) is not None for name in rotation.__all__)
    with pytest.raises(AttributeError, match="nonsense"):
        rotation.nonsense  # noqa: B018
