"""Agreement with scipy on 20 000 random rotations, compared as matrices; 100 000 with HFIELD_THOROUGH=1."""

import itertools

import numpy as np
import pytest

from rotation import Rotation, Slerp, slerp
from tests.subcases import subcases
from tests.thorough import cases

scipy_rotation = pytest.importorskip("scipy.spatial.transform")
S = scipy_rotation.Rotation

N = cases(100_000)
TOLERANCE = 1e-14
SEQUENCES = [a + b + c for a, b, c in itertools.product("xyz", repeat=3) if a != b != c]
SHORT = [s for n in (1, 2) for s in map("".join, itertools.permutations("xyz", n))]


@pytest.fixture(scope="module")
def pair() -> tuple[Rotation, object]:
    r = Rotation.random(N, rng=1)
    return r, S.from_quat(r.as_quat(scalar_first=False))


def difference(r: Rotation, s: object) -> float:
    return float(np.abs(r.as_matrix() - s.as_matrix()).max())  # type: ignore[attr-defined]


def test_constructors(pair: tuple[Rotation, object]) -> None:
    _, s = pair
    q, m = s.as_quat(), s.as_matrix()  # type: ignore[attr-defined]
    assert difference(Rotation.from_quat(3 * q, scalar_first=False), S.from_quat(3 * q)) < TOLERANCE
    assert difference(Rotation.from_matrix(m), S.from_matrix(m)) < TOLERANCE
    v = np.random.default_rng(2).uniform(-4, 4, (N, 3))
    assert difference(Rotation.from_rotvec(v), S.from_rotvec(v)) < TOLERANCE
    assert difference(Rotation.from_mrp(v), S.from_mrp(v)) < TOLERANCE
    angle = np.random.default_rng(3).uniform(-7, 7, N)
    axis = v / np.linalg.norm(v, axis=1)[:, None]
    ours = Rotation.from_axis_angle(v, angle)
    assert difference(ours, S.from_rotvec(axis * angle[:, None])) < TOLERANCE
    assert difference(Rotation.from_scipy(s), s) < TOLERANCE
    rough = m + 0.1 * np.random.default_rng(4).standard_normal(m.shape)
    rough = rough[np.linalg.det(rough) > 0.1]
    ours = Rotation.from_matrix(rough, orthonormalize=True)
    assert difference(ours, S.from_matrix(rough)) < 1e-13  # both by singular values


@subcases("seq", SEQUENCES + [s.upper() for s in SEQUENCES])
def test_all_24_sequences(seq: str, pair: tuple[Rotation, object]) -> None:
    angles = np.random.default_rng(5).uniform(-np.pi, np.pi, (N, 3))
    assert difference(Rotation.from_euler(seq, angles), S.from_euler(seq, angles)) < TOLERANCE
    r, s = pair
    assert difference(Rotation.from_euler(seq, r.as_euler(seq)), s) < TOLERANCE
    few = slice(0, 5000)
    turns = np.abs(r[few].as_euler(seq) - s[few].as_euler(seq))  # type: ignore[index]
    assert np.minimum(turns, 2 * np.pi - turns).max() < 1e-11


@subcases("seq", SHORT + [s.upper() for s in SHORT])
def test_one_and_two_letters(seq: str) -> None:
    angles = np.random.default_rng(6).uniform(-400, 400, (1000, len(seq)))
    ours = Rotation.from_euler(seq, angles, degrees=True)
    assert difference(ours, S.from_euler(seq, angles, degrees=True)) < TOLERANCE


def test_representations(pair: tuple[Rotation, object]) -> None:
    r, s = pair
    for ours, theirs in [
        (r.as_rotvec(), s.as_rotvec()),  # type: ignore[attr-defined]
        (r.as_mrp(), s.as_mrp()),  # type: ignore[attr-defined]
        (r.magnitude(), s.magnitude()),  # type: ignore[attr-defined]
        (
            r.as_quat(canonical=True, scalar_first=False),
            s.as_quat(canonical=True),  # type: ignore[attr-defined]
        ),
    ]:
        assert np.abs(ours - theirs).max() < TOLERANCE


def test_the_group_and_the_points(pair: tuple[Rotation, object]) -> None:
    r, s = pair
    assert difference(r * r[::-1], s * s[::-1]) < TOLERANCE  # type: ignore[index, operator]
    assert difference(r.inv(), s.inv()) < TOLERANCE  # type: ignore[attr-defined]
    assert difference(r**0.3, s**0.3) < TOLERANCE  # type: ignore[operator]
    v = np.random.default_rng(7).standard_normal((N, 3))
    assert np.abs(r.apply(v) - s.apply(v)).max() < TOLERANCE  # type: ignore[attr-defined]
    inverse = s.apply(v, inverse=True)  # type: ignore[attr-defined]
    assert np.abs(r.apply(v, inverse=True) - inverse).max() < TOLERANCE


def test_mean_align_and_slerp(pair: tuple[Rotation, object]) -> None:
    r, s = (x[:50] for x in pair)  # type: ignore[index]
    w = np.random.default_rng(8).uniform(0, 1, 50)
    assert difference(r.mean(w), s.mean(w)) < 1e-13
    a, b = np.random.default_rng(9).standard_normal((2, 50, 3))
    ours, rssd = Rotation.align_vectors(a, b, w)
    theirs, wanted = S.align_vectors(a, b, w)
    assert difference(ours, theirs) < 1e-13
    assert rssd == pytest.approx(wanted)
    times, at = np.arange(50.0), np.linspace(0, 49, 333)
    theirs = scipy_rotation.Slerp(times, s)(at)
    assert difference(Slerp(times, r)(at), theirs) < TOLERANCE
    assert difference(slerp(r[0], r[1], 0.3), scipy_rotation.Slerp([0, 1], s[:2])(0.3)) < TOLERANCE


def test_there_and_back() -> None:
    for shape in ((), (3,)):
        r = Rotation.random(shape, rng=10)
        assert np.all(Rotation.from_scipy(r.to_scipy()).approx_equal(r, atol=1e-15))
        assert difference(r, r.to_scipy()) < TOLERANCE
