"""The habits of scipy's users: scalar last, item assignment, warnings."""

import copy
import pickle
import warnings

import numpy as np
import pytest

from rotation import Rotation as Ours
from rotation import RotationError
from rotation.compat import RigidTransform, Rotation, Slerp


def test_the_scalar_is_last_and_items_can_be_assigned() -> None:
    r = Rotation.from_quat([[0, 0, 0, 1], [0, 0, 1, 1]])
    np.testing.assert_allclose(r.as_quat()[1], [0, 0, 0.5**0.5, 0.5**0.5])
    before = copy.deepcopy(r)
    r[0] = r[1]
    assert r.approx_equal(before[1]).all()
    assert before[0].magnitude() == 0.0
    t = RigidTransform.identity(2)
    t[1] = RigidTransform.from_translation([1, 2, 3])
    np.testing.assert_array_equal(t.translation, [[0, 0, 0], [1, 2, 3]])
    assert pickle.loads(pickle.dumps(r)).approx_equal(r).all()


def test_gimbal_lock_warns() -> None:
    r = Rotation.from_euler("zyx", [10, 90, 20], degrees=True)
    with pytest.warns(UserWarning, match="Gimbal lock"):
        angles = r.as_euler("zyx", degrees=True)
    assert angles[2] == 0.0
    assert Rotation.from_euler("zyx", angles, degrees=True).approx_equal(r, atol=1e-7)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        r.as_euler("zyx", suppress_warnings=True)


def test_the_arithmetic_is_ours() -> None:
    r = Rotation.random(20, rng=1)
    ours = Ours.from_quat(r.as_quat(), scalar_first=False)
    np.testing.assert_array_equal(r.as_matrix(), ours.as_matrix())
    np.testing.assert_array_equal((r * r).as_rotvec(), (ours * ours).as_rotvec())
    np.testing.assert_array_equal(Slerp([0, 1], r[:2])(0.3).as_quat().shape, (4,))


def test_inverse_motions_undo() -> None:
    r = Rotation.random(5, rng=2)
    t = RigidTransform.from_components(np.arange(15.0).reshape(5, 3), r)
    points = np.random.default_rng(3).standard_normal((5, 3))
    np.testing.assert_allclose(t.inv().apply(t.apply(points)), points, atol=1e-13)
    np.testing.assert_allclose(t.apply(t.inv().apply(points)), points, atol=1e-13)
    np.testing.assert_array_equal(t.inv().as_matrix(), (t**-1).as_matrix())


def test_errors_are_value_errors_of_ours() -> None:
    with pytest.raises(RotationError, match="Expected `quat`"):
        Rotation.from_quat([1, 2, 3])
    with pytest.raises(RotationError, match="Non-positive determinant"):
        Rotation.from_matrix(-np.eye(3))


def test_what_has_no_one_answer_has_scipys() -> None:
    scipys = pytest.importorskip("scipy.spatial.transform")
    S, ST = scipys.Rotation, scipys.RigidTransform
    rng = np.random.default_rng(2)
    for q in (np.eye(4), [[1, 0, 0, 0], [0, 1, 0, 0]], [[0, 0, 0, 1], [1, 0, 0, 0]]):
        for weights in (None, np.zeros(len(q))):
            means = [kind.from_quat(q).mean(weights).as_quat(True) for kind in (S, Rotation)]
            np.testing.assert_allclose(means[1], means[0], atol=1e-12)
        moves = [kind.from_rotation(S.from_quat(q)).mean() for kind in (ST, RigidTransform)]
        np.testing.assert_allclose(moves[1].as_matrix(), moves[0].as_matrix(), atol=1e-12)
    a = rng.standard_normal((5, 3))
    line = np.outer([1, 2, -0.5], [0, 0, 1.0])
    for u, v in ((np.eye(3), -np.eye(3)), (a, np.outer(a[:, 0], a[0])), (line, line[:, ::-1])):
        found = []
        for kind in (S, Rotation):
            with pytest.warns(UserWarning, match="Optimal rotation is not uniquely or poorly"):
                found.append(kind.align_vectors(u, v))
        assert found[1][1] == pytest.approx(found[0][1], abs=1e-7)
        assert Rotation.approx_equal(found[1][0], found[0][0], atol=1e-7)
    for u, v in ((a[0], 2 * a[1]), (a[:1], a[:1])):
        found = [kind.align_vectors(u, v) for kind in (S, Rotation)]
        assert found[1][1] == pytest.approx(found[0][1], abs=1e-12)
    shear = np.eye(3) + 0.3 * rng.standard_normal((20, 3, 3))
    matrices = np.concatenate([shear, -shear, S.random(20, rng=3).as_matrix()])
    taken = [kind.from_matrix(matrices, assume_valid=True).as_matrix() for kind in (S, Rotation)]
    np.testing.assert_allclose(taken[1], taken[0], atol=1e-14)
    with pytest.raises(RotationError, match="NaN"):
        Rotation.from_quat([[0, 0, 0, 1], [0, np.nan, 0, 1]])
    with pytest.raises(RotationError, match="within the range"):
        Slerp([0, 1], Rotation.identity(2))(np.nan)
