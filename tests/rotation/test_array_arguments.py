"""Every public function reads array arguments alike: masks, numbers that are not finite, bytes, strides."""

import inspect
import warnings
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from matplotlib.figure import Figure

import rotation
from rotation import (
    R2,
    BSpline,
    RigidTransform,
    Rotation,
    RotationError,
    RotationSpline,
    Slerp,
    Squad,
    Uncertain,
    ad,
    align_points,
    align_similarity,
    angular_velocity,
    compat,
    convert_points,
    hat,
    integrate,
    inverse_left_jacobian,
    inverse_right_jacobian,
    left_jacobian,
    look_at,
    plane,
    reflect2,
    reflection,
    right_jacobian,
    rotate,
    rotate2,
    rotate_euler,
    rotate_quat,
    sclerp,
    slerp,
    squad,
    swing_twist,
    vee,
)
from tests.subcases import subcases

RNG = np.random.default_rng(7)
N = 5
V, W, A, S, Q = (RNG.standard_normal(s) for s in ((N, 3), (N, 3), N, (N, 6), (N, 4)))
T, WEIGHTS, TIMES = RNG.random(N), RNG.random(N) + 0.5, np.arange(N) + 0.5
R = Rotation(Q)
M = RigidTransform.from_components(V, R)
BELIEF = Uncertain(M[0], np.eye(6))


def plane_limits(points: Any, angles: Any) -> np.ndarray:
    return rotation.draw_plane(Figure().add_subplot(), points, angles).dataLim.get_points()


def space_limits(points: Any) -> np.ndarray:
    return np.array(R[0].plot(Figure().add_subplot(projection="3d"), points).get_w_lims())


CURVES: dict[str, Callable[[Any, Any], Any]] = {
    "Slerp": Slerp,
    "Squad": Squad,
    "RotationSpline": RotationSpline,
}
BASIS = np.broadcast_to(np.eye(3), (N, 3, 3)).copy()

# name, function of the arrays, arrays; and whether rows of the arrays give rows of the answer
BY_ROWS: list[tuple[str, Callable[..., Any], tuple[np.ndarray, ...]]] = [
    ("R2", R2, (A,)),
    ("R_x", rotation.R_x, (A,)),
    ("R_y", rotation.R_y, (A,)),
    ("R_z", rotation.R_z, (A,)),
    ("T_q", rotation.T_q, (Q, V)),
    ("ad", ad, (S,)),
    ("convert_points", lambda v: convert_points(v, "ros", "opencv"), (V,)),
    ("hat", hat, (V,)),
    ("inverse_left_jacobian", inverse_left_jacobian, (S,)),
    ("inverse_right_jacobian", inverse_right_jacobian, (V,)),
    ("left_jacobian", left_jacobian, (S,)),
    ("right_jacobian", right_jacobian, (V,)),
    ("look_at", lambda a, b, c: look_at(a, b, c).as_matrix(), (V, V + W, S[:, :3].copy())),
    ("reflect2", reflect2, (V[:, :2].copy(), A)),
    ("reflection", reflection, (A,)),
    ("rotate", rotate, (V, W, A)),
    ("rotate2", rotate2, (V[:, :2].copy(), A)),
    ("rotate_euler", rotate_euler, (V, W)),
    ("rotate_quat", rotate_quat, (V, Q)),
    ("sclerp", lambda t: sclerp(M, M.inverse(), t).as_matrix(), (T,)),
    ("slerp", lambda t: slerp(R, R.inverse(), t).as_quat(), (T,)),
    ("squad", lambda t: squad(R, R, R.inverse(), R, t).as_quat(), (T,)),
    ("swing_twist", lambda a: swing_twist(R, a)[0].as_quat(), (V,)),
    ("vee", vee, (hat(V),)),
    ("Rotation", lambda q: Rotation(q).as_quat(), (Q,)),
    ("Rotation.from_quat", lambda q: Rotation.from_quat(q, scalar_first=False).as_quat(), (Q,)),
    ("Rotation.from_matrix", lambda m: Rotation.from_matrix(m).as_quat(), (R.as_matrix(),)),
    (
        "Rotation.from_matrix",
        lambda m: Rotation.from_matrix(m, orthonormalize=True).as_quat(),
        (R.as_matrix(),),
    ),
    ("Rotation.from_rotvec", lambda v: Rotation.from_rotvec(v).as_quat(), (V,)),
    ("Rotation.from_axis_angle", lambda *a: Rotation.from_axis_angle(*a).as_quat(), (V, A)),
    ("Rotation.from_euler", lambda a: Rotation.from_euler("ZYX", a).as_quat(), (V,)),
    ("Rotation.from_mrp", lambda v: Rotation.from_mrp(v).as_quat(), (V,)),
    ("Rotation.from_6d", lambda v: Rotation.from_6d(v).as_quat(), (S,)),
    (
        "Rotation.from_davenport",
        lambda b, a: Rotation.from_davenport(b, "intrinsic", a).as_quat(),
        (BASIS, V),
    ),
    ("Rotation.as_davenport", lambda b: R.as_davenport(b, "intrinsic"), (BASIS,)),
    ("Rotation.between", lambda *a: Rotation.between(*a).as_quat(), (V, W)),
    ("Rotation.apply", R.apply, (V,)),
    ("Rotation.__pow__", lambda t: (R**t).as_quat(), (A,)),
    ("Rotation.plus", lambda v: R.plus(v).as_quat(), (V,)),
    ("Rotation.exp", lambda v: Rotation.exp(v).as_quat(), (V,)),
    (
        "RigidTransform.from_matrix",
        lambda m: RigidTransform.from_matrix(m).as_matrix(),
        (M.as_matrix(),),
    ),
    (
        "RigidTransform.from_translation",
        lambda v: RigidTransform.from_translation(v).as_matrix(),
        (V,),
    ),
    (
        "RigidTransform.from_exp_coords",
        lambda v: RigidTransform.from_exp_coords(v).as_matrix(),
        (S,),
    ),
    (
        "RigidTransform.from_dual_quat",
        lambda d: RigidTransform.from_dual_quat(d).as_matrix(),
        (M.as_dual_quat(),),
    ),
    (
        "RigidTransform.from_components",
        lambda v: RigidTransform.from_components(v, R).as_matrix(),
        (V,),
    ),
    (
        "RigidTransform.from_screw",
        lambda *a: RigidTransform.from_screw(*a).as_matrix(),
        (V, W, A, T),
    ),
    ("RigidTransform.exp", lambda v: RigidTransform.exp(v).as_matrix(), (S,)),
    ("Uncertain.interpolate", lambda t: BELIEF.interpolate(BELIEF, t).covariance, (T,)),
    ("RigidTransform.apply", M.apply, (V,)),
    ("RigidTransform.__pow__", lambda t: (M**t).as_matrix(), (A,)),
    ("RigidTransform.plus", lambda v: M.plus(v).as_matrix(), (S,)),
    *((name, lambda t, c=c: c(TIMES, R)(t).as_quat(), (T + 1,)) for name, c in CURVES.items()),
    ("BSpline", lambda t: BSpline(R)(t).as_quat(), (T + 1,)),
]
# the whole answer comes from all rows
TOGETHER: list[tuple[str, Callable[..., Any], tuple[np.ndarray, ...]]] = [
    ("Rotation.mean", lambda w: R.mean(w).as_quat(), (WEIGHTS,)),
    ("Rotation.median", lambda w: R.median(w).as_quat(), (WEIGHTS,)),
    ("RigidTransform.mean", lambda w: M.mean(w).as_matrix(), (WEIGHTS,)),
    ("Rotation.align_vectors", lambda *a: Rotation.align_vectors(*a)[0].as_quat(), (V, W, WEIGHTS)),
    ("RigidTransform.align", lambda *a: RigidTransform.align(*a)[0].as_matrix(), (V, W, WEIGHTS)),
    ("align_points", lambda *a: align_points(*a)[1], (V, W, WEIGHTS)),
    ("align_similarity", lambda *a: align_similarity(*a).translation, (V, W, WEIGHTS)),
    ("angular_velocity", lambda t: angular_velocity(R, t), (TIMES,)),
    ("integrate", lambda w, t: integrate(w, t).as_quat(), (V, TIMES)),
    ("Rotation.apply_outer", R.apply_outer, (V,)),
    *((name, lambda t, c=c: c(t, R)(2.0).as_quat(), (TIMES,)) for name, c in CURVES.items()),
    ("Uncertain", lambda p: Uncertain(M, p).covariance, (np.eye(6) + np.zeros((N, 6, 6)),)),
    ("draw_plane", plane_limits, (V[:, :2], A)),
    ("Rotation.plot", space_limits, (V,)),
]
CALLS = [*BY_ROWS, *TOGETHER]
# what the parameters of methods that are arrays of numbers are called
ARRAYS = {
    "a", "angle", "angles", "axes", "dual_quat", "exp_coords", "matrix", "mrp", "numbers", "points", "quat",
    "rotvec", "source", "t", "tangent", "target", "translation", "weights",
}  # fmt: skip
# without arrays of numbers among their arguments
WITHOUT = {
    "LETTER_T", "Screw", "Similarity", "align", "benchmark", "compat", "change_of_axes", "convert_rotation",
    "convert_transform", "exact_group", "exact_matrix", "from_exact", "threads", "warm_up",
}  # fmt: skip


def variants(calls: Any) -> list[Any]:
    return [(function, arrays, n) for _, function, arrays in calls for n in range(len(arrays))]


def call(function: Callable[..., Any], arrays: tuple[Any, ...], n: int, array: Any) -> Any:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        return np.asarray(function(*arrays[:n], array, *arrays[n + 1 :]))


def test_every_public_function_is_called_here() -> None:
    called = {name.partition(".")[0] for name, _, _ in CALLS}
    public = {
        name
        for name in rotation.__all__
        if not (
            inspect.isclass(getattr(rotation, name))
            and issubclass(getattr(rotation, name), Exception)
        )
    }
    assert public == called | WITHOUT


@pytest.mark.parametrize("kind", [Rotation, RigidTransform, Uncertain])
def test_every_method_with_an_array_argument_is_called_here(kind: type) -> None:
    called = {name for name, _, _ in CALLS}
    for name in {n for base in kind.__mro__ for n in vars(base) if not n.startswith("_")}:
        method = inspect.getattr_static(kind, name)
        method = getattr(method, "__func__", method)
        if inspect.isfunction(method) and set(inspect.signature(method).parameters) & ARRAYS:
            assert f"{kind.__name__}.{name}" in called


@subcases(("function", "arrays", "n"), variants(CALLS))
def test_masks_are_refused(function: Any, arrays: Any, n: int) -> None:
    mask = np.zeros(arrays[n].shape, bool)
    mask[1] = True
    with pytest.raises(RotationError, match="masked"):
        call(function, arrays, n, np.ma.array(arrays[n], mask=mask))


@subcases(("function", "arrays", "n"), variants(CALLS))
def test_bytes_and_strides_make_no_difference(function: Any, arrays: Any, n: int) -> None:
    expected = call(function, arrays, n, arrays[n])
    swapped = arrays[n].astype(arrays[n].dtype.newbyteorder())
    wide = np.repeat(arrays[n], 2, axis=0)[::2]
    backwards = arrays[n][::-1].copy()[::-1]
    for other in (swapped, wide, backwards, np.asfortranarray(arrays[n]), arrays[n].tolist()):
        np.testing.assert_array_equal(call(function, arrays, n, other), expected)


@subcases("bad", [np.nan, np.inf, -np.inf])
@subcases(("function", "arrays", "n"), variants(BY_ROWS))
def test_a_row_that_is_not_finite_gives_no_finite_row_or_an_error(
    function: Any, arrays: Any, n: int, bad: float
) -> None:
    """In whatever place of the row; no other row changes, and there is no warning."""
    expected = call(function, arrays, n, arrays[n])
    for place in np.ndindex(arrays[n].shape[1:]):
        spoilt = arrays[n].copy()
        spoilt[(2, *place)] = bad
        try:
            found = call(function, arrays, n, spoilt)
        except RotationError:
            continue
        others = np.arange(N) != 2
        np.testing.assert_array_equal(found[others], expected[others])
        assert not np.isfinite(found[2]).all()


@subcases("bad", [np.nan, np.inf])
@subcases(("function", "arrays", "n"), variants(TOGETHER))
def test_numbers_that_are_not_finite_give_no_warning(
    function: Any, arrays: Any, n: int, bad: float
) -> None:
    spoilt = arrays[n].copy()
    spoilt[2] = bad
    try:
        call(function, arrays, n, spoilt)
    except RotationError:
        return


def test_masks_in_lists_and_in_compat_are_refused() -> None:
    row = np.ma.array([1.0, 2, 3], mask=[True, False, False])
    turn = compat.Rotation.identity()
    for refused in (
        lambda: rotate([row, row], V[:2], A[:2]),
        lambda: Rotation.from_euler("ZYX", [1.0, np.ma.masked, 2.0]),
        lambda: plane.from_complex(np.ma.array([1j], mask=[True])),
        lambda: turn.apply(row),
        lambda: compat.Rotation.from_rotvec(row),
        lambda: compat.Rotation.from_euler("xyz", row),
        lambda: compat.RigidTransform.from_translation(row),
        lambda: compat.RigidTransform.identity().apply(row),
        lambda: compat.Rotation.concatenate([turn] * 3).mean(row),
        lambda: compat.Rotation.align_vectors([row, row], V[:2]),
        lambda: compat.Slerp(row, compat.Rotation.concatenate([turn] * 3)),
    ):
        with pytest.raises(RotationError, match="masked"):
            refused()


def test_the_reported_cases() -> None:
    for bad in (np.nan, np.inf):
        assert np.isnan(vee(hat(V[0]) + np.diag([bad, 0, 0]))).all()
        assert np.isnan(convert_points([[bad, 0, 0], [1, 2, 3]], "ros", "opencv")).tolist() == [
            [True] * 3,
            [False] * 3,
        ]
