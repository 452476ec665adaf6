"""Rotations of ours, of scipy and of `rotation.compat` meet: it works, or the error says what to write."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from rotation import (
    DTypeError,
    ForeignArrayError,
    RigidTransform,
    Rotation,
    RotationError,
    RotationSpline,
    Slerp,
    Squad,
    compat,
    convert_rotation,
    integrate,
    rotate_quat,
    sclerp,
    slerp,
    squad,
    swing_twist,
)
from rotation.errors import ArgumentError
from tests.subcases import subcases

scipys = pytest.importorskip("scipy.spatial.transform")

Q = np.random.default_rng(1).standard_normal((3, 4))
V = np.random.default_rng(2).standard_normal((3, 3))
R = Rotation(Q)
T = RigidTransform.from_components(V, R)
C, CT = compat.Rotation, compat.RigidTransform
S, ST = scipys.Rotation, scipys.RigidTransform
FOREIGN = {
    "scipy.spatial.transform": (S.from_quat(Q, scalar_first=True), ST.from_matrix(T.as_matrix())),
    "rotation.compat": (C.from_quat(Q, scalar_first=True), CT.from_matrix(T.as_matrix())),
}
TAKING: dict[str, Callable[[Any], Any]] = {
    "slerp": lambda x: slerp(R, x, 0.5),
    "squad": lambda x: squad(R, R, x, R, 0.5),
    "Slerp": lambda x: Slerp([0, 1, 2], x),
    "Squad": lambda x: Squad([0, 1, 2], x),
    "RotationSpline": lambda x: RotationSpline([0, 1, 2], x),
    "integrate": lambda x: integrate([0, 0, 1], [0, 1], x),
    "swing_twist": lambda x: swing_twist(x, [0, 0, 1]),
    "convert_rotation": lambda x: convert_rotation(x, "ros", "unity"),
    "approx_equal": R.approx_equal,
    "outer": R.outer,
    "reduce": lambda x: R.reduce(right=x),
    "concatenate": lambda x: Rotation.concatenate([R, x]),
    "from_rotation": RigidTransform.from_rotation,
    "from_components": lambda x: RigidTransform.from_components(V, x),
}
MOVING: dict[str, Callable[[Any], Any]] = {
    "sclerp": lambda x: sclerp(T, x, 0.5),
    "approx_equal": T.approx_equal,
    "concatenate": lambda x: RigidTransform.concatenate([T, x]),
}
NUMBERS: dict[str, Callable[[Any], Any]] = {
    "from_quat": Rotation,
    "scalar last": lambda x: Rotation.from_quat(x, scalar_first=False),
    "from_matrix": Rotation.from_matrix,
    "from_rotvec": Rotation.from_rotvec,
    "apply": R.apply,
    "apply_outer": R.apply_outer,
    "transform": T.apply,
    "rotate_quat": lambda x: rotate_quat(x, Q),
    "exponent": lambda x: R**x,
    "omega": lambda x: integrate(x, [0, 1]),
}


@subcases("home", FOREIGN)
@subcases("name", TAKING)
def test_who_takes_rotations_says_whose_they_are_and_what_to_write(home: str, name: str) -> None:
    turn, move = FOREIGN[home]
    with pytest.raises(DTypeError) as error:
        TAKING[name](turn)
    assert f"a {home}.Rotation; expected a rotation.Rotation" in str(error.value)
    assert "write Rotation.from_scipy(" in str(error.value)
    with pytest.raises(DTypeError, match=r"RigidTransform; expected a Rotation: write Rotation\."):
        TAKING[name](move)
    with pytest.raises(DTypeError, match=r"rotation\.RigidTransform; .*: write .*\.rotation"):
        TAKING[name](T)
    with pytest.raises(
        DTypeError, match=r"ndarray; expected a Rotation: write Rotation\.from_quat"
    ):
        TAKING[name](Q)


@pytest.mark.parametrize("home", FOREIGN)
@pytest.mark.parametrize("name", MOVING)
def test_who_takes_transforms_says_so_too(home: str, name: str) -> None:
    turn, move = FOREIGN[home]
    with pytest.raises(DTypeError, match=r"write RigidTransform\.from_matrix\(.*as_matrix"):
        MOVING[name](move)
    for given, way in (
        (turn, r"from_rotation\(Rotation\.from_scipy\("),
        (R, r"from_rotation\([rq]|other"),
    ):
        with pytest.raises(DTypeError, match=way):
            MOVING[name](given)
    with pytest.raises(DTypeError, match=r"write RigidTransform\.from_matrix"):
        MOVING[name](T.as_matrix())


@subcases("home", ["rotation", *FOREIGN])
@subcases("name", NUMBERS)
def test_who_takes_numbers_names_the_class(home: str, name: str) -> None:
    for value in (R, T) if home == "rotation" else FOREIGN[home]:
        with pytest.raises(DTypeError, match=rf"is a {home}\.\w+; expected an array of numbers"):
            NUMBERS[name](value)


def test_lists_of_rotations_are_to_be_joined() -> None:
    for call in (lambda: Slerp([0, 1], [R[0], R[1]]), lambda: slerp(R, (R[0],), 0.5)):  # type: ignore[arg-type]
        with pytest.raises(
            DTypeError, match=r"of rotation\.Rotation; .* write Rotation\.concatenate"
        ):
            call()
    with pytest.raises(DTypeError, match=r"RigidTransform\.concatenate"):
        sclerp(T, [T[0], T[1]], 0.5)  # type: ignore[arg-type]
    with pytest.raises(
        DTypeError, match=r"a list of scipy\.spatial\.transform\.Rotation; expected"
    ):
        R.apply(list(FOREIGN["scipy.spatial.transform"][0]))
    for value, name in ((None, "NoneType"), ({}, "dict"), ((x for x in "ab"), "generator")):
        with pytest.raises(DTypeError, match=f"points is a {name}; expected an array of numbers"):
            R.apply(value)


def test_what_is_said_works() -> None:
    for turn, move in FOREIGN.values():
        assert R.approx_equal(Rotation.from_scipy(turn), 1e-14).all()
        assert R.approx_equal(Rotation.from_scipy(move.rotation), 1e-14).all()
        assert T.approx_equal(RigidTransform.from_matrix(move.as_matrix()), 1e-14).all()
        turned = rotate_quat(V, turn.as_quat(scalar_first=True))
        np.testing.assert_allclose(turned, R.apply(V), atol=1e-14)
    with pytest.raises(DTypeError, match=r"rotation\.Rotation; expected a scipy\."):
        Rotation.from_scipy(R)


def test_beside_scipys_compat_multiplies_and_ours_says_what_to_write() -> None:
    turn, move = FOREIGN["rotation.compat"]
    wanted, moved = R * R, T * T
    for other in (R, turn, FOREIGN["scipy.spatial.transform"][0]):
        for product in (turn * other, other * turn):
            assert type(product) is C
            assert wanted.approx_equal(Rotation.from_scipy(product), 1e-14).all()
    for other in (T, move, FOREIGN["scipy.spatial.transform"][1]):
        for product in (move * other, other * move):
            assert type(product) is CT
            np.testing.assert_allclose(product.as_matrix(), moved.as_matrix(), atol=1e-14)
    p, q = C.from_rotvec([0.1, 0.2, 0.3]), Rotation.from_rotvec([0.3, -1, 0])
    assert q.inv().approx_equal(Rotation.from_scipy((p * q).inv() * p), 1e-14)
    assert q.inv().approx_equal(Rotation.from_scipy(p * (q * p).inv()), 1e-14)
    theirs = FOREIGN["scipy.spatial.transform"]
    for call, way in (
        (lambda: R * theirs[0], "from_scipy"),
        (lambda: theirs[0] * R, "from_scipy"),
        (lambda: T * theirs[1], "from_matrix"),
        (lambda: theirs[1] * T, "from_matrix"),
        (lambda: R * theirs[1], "from_matrix"),
        (lambda: T * theirs[0], "from_rotation.Rotation.from_scipy"),
        (lambda: T * turn, "from_rotation.Rotation.from_scipy"),
        (lambda: turn * T, "from_rotation"),
    ):
        with pytest.raises(DTypeError, match=way):
            call()


def test_a_rotation_beside_a_motion_is_a_motion() -> None:
    """As in scipy 1.18; against products of matrices."""
    turn, move = FOREIGN["rotation.compat"]
    theirs = FOREIGN["scipy.spatial.transform"][0]
    m = np.zeros((3, 4, 4))
    m[:, 3, 3] = 1
    m[:, :3, :3] = R.as_matrix()
    for r, t, kind in (
        (R, T, RigidTransform),
        (turn, move, CT),
        (R, move, CT),
        (theirs, move, CT),
    ):
        for product, wanted in ((r * t, m @ T.as_matrix()), (t * r, T.as_matrix() @ m)):
            assert type(product) is kind
            np.testing.assert_allclose(product.as_matrix(), wanted, rtol=0, atol=1e-14)
    assert (R[0] * T).shape == (T * R[:1]).shape == (3,)
    with pytest.raises(RotationError, match="broadcast"):
        R[:2] * T


@pytest.mark.parametrize(
    ("call", "way"),
    [
        (lambda: Rotation.random(3, random_state=1), "random_state: write seed=1"),
        (lambda: Rotation.random(num=3), "num: write shape=3"),
        (lambda: Rotation.identity(num=3), "num: write shape=3"),
        (lambda: Rotation.from_matrix(np.eye(3), assume_valid=True), "assume_valid: leave it out"),
        (lambda: R.as_euler("xyz", suppress_warnings=True), "suppress_warnings: leave it out"),
        (lambda: Rotation.random(3, sed=1), "random has no argument sed$"),
    ],
)
def test_arguments_of_scipys_say_what_to_write(call: Callable[[], Any], way: str) -> None:
    with pytest.raises(ArgumentError, match=way):
        call()


def test_compat_takes_all_three_kinds() -> None:
    for other in (R, *(turn for turn, _ in FOREIGN.values())):
        c = FOREIGN["rotation.compat"][0]
        assert c.approx_equal(other).all()
        assert C.concatenate([c, other]).shape == (6,)
        assert type(C.concatenate(other)) is C
        assert compat.Slerp([0, 1, 2], other)(0.5).approx_equal(slerp(R[0], R[1], 0.5), 1e-12)
        assert compat.RotationSpline([0, 1, 2], other)(1.0).approx_equal(R[1], 1e-12)
        assert CT.from_components(V, other).rotation.approx_equal(R, 1e-12).all()
        assert c.reduce(other).shape == c.reduce(None, other).shape == (3,)
        changed = C.identity(3)
        changed[:] = other
        assert changed.approx_equal(R).all()
    for other in (T, *(move for _, move in FOREIGN.values())):
        assert CT.concatenate([CT.identity(), other]).shape == (4,)
        changed = CT.identity(3)
        changed[1:] = other[1:]
        np.testing.assert_allclose(changed.as_matrix()[1:], T.as_matrix()[1:], atol=1e-15)
    for call in (
        lambda: C.concatenate([R, 1]),
        lambda: C.identity().approx_equal(Q),
        lambda: compat.Slerp([0, 1, 2], Q),
        lambda: CT.from_rotation(T),
    ):
        with pytest.raises(DTypeError, match="this is a"):
            call()


def test_arrays_of_other_libraries_stay_where_they_are() -> None:
    strict = pytest.importorskip("array_api_strict")
    other = Rotation(strict.asarray(Q))
    moves = RigidTransform.from_rotation(other)
    turn, move = FOREIGN["rotation.compat"]
    for call in (lambda: turn * other, lambda: other * turn, lambda: move * moves):
        with pytest.raises(ForeignArrayError, match="compat takes numpy arrays only"):
            call()
    for call in (other.reduce, lambda: other.reduce(R), lambda: R.reduce(other)):
        with pytest.raises(ForeignArrayError, match="reduce takes numpy arrays only"):
            call()


@subcases("group", ["T", "O", "I", "C1", "C5", "D1", "D2", "D7"])
@subcases("axis", ["X", "y"])
def test_groups_of_compat_are_in_scipys_order(group: str, axis: str) -> None:
    ours, theirs = (kind.create_group(group, axis).as_quat() for kind in (C, S))
    np.testing.assert_allclose(ours, theirs, atol=1e-15)


def test_of_equally_small_rotations_compat_takes_scipys() -> None:
    p, q = S.random(500, rng=1), C.random(500, rng=2)
    q[:] = p
    for left, right in (("O", "O"), ("I", "T"), ("C4", "O"), ("D6", None), (None, "I")):
        found = []
        for kind, turns in ((S, p), (C, q)):
            sides = (None if name is None else kind.create_group(name) for name in (left, right))
            found.append(turns.reduce(*sides, return_indices=True))
        (wanted, *indices), (reduced, *ours) = found
        np.testing.assert_allclose(reduced.as_quat(), wanted.as_quat(), atol=1e-14)
        for mine, theirs in zip(ours, indices, strict=True):
            assert (mine is None) == (theirs is None)
            assert mine is None or (mine == theirs).all()


@subcases(
    ("form", "advice"),
    [
        ("~r", r"r\.inv\(\)"),
        ("-r", r"r\.inv\(\)"),
        ("abs(r)", r"r\.magnitude\(\)"),
        ("r + r", r"p \* q"),
        ("1 + r", r"p \* q"),
        ("r - r", r"p\.inv\(\) \* q"),
        ("v - r", r"p\.inv\(\) \* q"),
        ("r / r", r"q\.inv\(\)"),
        ("1 / r", r"r\.inv\(\)"),
        ("r * 2", r"r\*\*n"),
        ("0.5 * r", r"r\*\*n"),
        ("r @ s", r"p \* q"),
        ("s @ r", r"p \* q"),
    ],
)
@subcases("r", [R, T])
def test_operators_that_there_are_not_say_what_to_write(form: str, advice: str, r: Any) -> None:
    with pytest.raises(DTypeError, match=f"write .*{advice}"):
        eval(form, {"r": r, "v": V, "s": FOREIGN["scipy.spatial.transform"][0]})


def test_names_of_other_libraries_say_ours() -> None:
    for thing, names in ((R, "w x T vec conjugate rotate as_dcm angle"), (T, "R t T transform")):
        for name in names.split():
            with pytest.raises(AttributeError, match=f"no '{name}': write "):
                getattr(thing, name)
            assert not hasattr(thing, name)
            assert name not in dir(thing)
    assert "as_quat" in dir(R)
    with pytest.raises(AttributeError, match="from_matrix"):
        Rotation.from_dcm  # type: ignore[attr-defined]  # noqa: B018


def test_quaternions_of_numpy_quaternion_are_taken() -> None:
    quaternion = pytest.importorskip("quaternion")
    given = quaternion.as_quat_array(Q)
    assert (Rotation(given) == R).all()
    assert Rotation(given[1]) == R[1]
    np.testing.assert_array_equal(rotate_quat(V, given), rotate_quat(V, Q))
    with pytest.raises(RotationError, match="shape"):
        R.apply(given)
