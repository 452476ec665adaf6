"""Formulas as machine code: the same numbers as by numpy, whatever the shapes, strides and threads."""

import gc
import os
import pickle
import subprocess
import sys
import weakref
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from hfield.compiling import disk_cache
from rotation import Rotation, threads
from rotation.namespaces import namespace, quiet
from rotation.native import builtins
from rotation.native.entry import MUCH
from rotation.quaternions import INVERSE, PRODUCT, SHORTER_POWER, _product, normalise
from rotation.rowwise import RowFormula
from tests.subcases import subcases

RNG = np.random.default_rng(11)
UNITS = Rotation.random(40_000, seed=1).as_quat()


def run(code: str, **variables: str) -> str:
    found = subprocess.run(
        [sys.executable, "-c", code],
        capture_output=True,
        text=True,
        check=True,
        env={**os.environ, **variables},
    )
    return found.stdout.strip()


@subcases("n", [0, 1, 2, 7, 8, 9, 15, 17, 100, 5000, 40_000])
def test_every_number_of_rows(n: int) -> None:
    p, q = UNITS[:n], UNITS[::-1][:n]
    np.testing.assert_array_equal(PRODUCT(p, q), _product(p, q))


@subcases(
    ("width", "places", "signs"),
    [
        (4, (0, 1, 2, 3), (1, -1, -1, -1)),
        (4, (1, 2, 3, 0), (1, 1, 1, 1)),
        (4, (2, 0), (-1, 1)),
        (2, (1, 1, 0), (1, -1, -1)),
        (9, (0, 3, 6, 1, 4, 7, 2, 5, 8), (-1, 1, 1, 1, 1, 1, 1, 1, 1)),
        (1, (0,), (-1,)),
    ],
)
def test_formulas_may_only_move_numbers_and_change_signs(
    width: int, places: tuple[int, ...], signs: tuple[int, ...]
) -> None:
    def moved(q: Any) -> Any:
        pairs = zip(places, signs, strict=True)
        columns = tuple(-q[..., k] if sign < 0 else q[..., k] for k, sign in pairs)
        return namespace(q).stack(columns, axis=-1)

    formula = RowFormula(moved, (width,))
    for n in (1, 8, 21):
        rows = RNG.standard_normal((n, width))
        rows[0, 0] = -0.0
        found, wanted = formula(rows), moved(rows)
        np.testing.assert_array_equal(found, wanted)
        np.testing.assert_array_equal(np.signbit(found), np.signbit(wanted))
        np.testing.assert_array_equal(formula(rows.astype(np.float32)), wanted.astype(np.float32))


@pytest.mark.parametrize("number", [1, 3])
def test_threads_share_the_rows(number: int, monkeypatch: pytest.MonkeyPatch) -> None:
    p = np.tile(UNITS, (5, 1))
    PRODUCT(p[:1], p[:1])  # now it is compiled
    monkeypatch.setattr(PRODUCT, "_shortest", len(p) // 4)
    before = threads()
    threads(number)
    try:
        np.testing.assert_array_equal(PRODUCT(p, p[::-1]), _product(p, p[::-1]))
        np.testing.assert_array_equal(PRODUCT(p, p[3]), _product(p, p[3]))
    finally:
        threads(before)


SHAPES: list[tuple[Any, Any]] = [
    ((), ()),
    ((), (5,)),
    ((5,), ()),
    ((1,), (5,)),
    ((4, 1), (5,)),
    ((4, 1), (1, 5)),
    ((2, 1, 3), (7, 1)),
    ((0,), (1,)),
    ((0, 3), (3,)),
    ((1, 1), ()),
]


@subcases(("one", "other"), SHAPES)
def test_batches_broadcast(one: Any, other: Any) -> None:
    p = RNG.standard_normal((*one, 4))
    q = RNG.standard_normal((*other, 4))
    wanted = _product(p, q)
    found = PRODUCT(p, q)
    assert found.shape == wanted.shape
    np.testing.assert_array_equal(found, wanted)


def test_every_stride_and_alignment() -> None:
    base = RNG.standard_normal((60, 8))
    raw = np.zeros(60 * 4 * 8 + 1, np.uint8)
    askew = raw[1:].view(np.float64).reshape(60, 4)
    askew[...] = base[:, :4]
    for q in (base[:, ::2], base[::-1, :4], np.asfortranarray(base[:, :4]), askew):
        np.testing.assert_array_equal(PRODUCT(q, q), _product(np.array(q), np.array(q)))


def test_a_formula_tells_of_rows_and_of_the_rows_alone() -> None:
    formula = RowFormula(normalise, (4,))
    for n in (1, 3, 8, 19):
        q = RNG.standard_normal((n, 4))
        assert not formula.with_flag(q)[1]
        for row in range(n):
            spoilt = q.copy()
            spoilt[row] = 0.0
            assert formula.with_flag(spoilt)[1]


@pytest.mark.slow
def test_without_machine_code_the_numbers_are_the_same_to_rounding() -> None:
    code = (
        "import numpy as np; from rotation import Rotation, rotate, rotate_euler\n"
        "from rotation.native import builtins\n"
        "r = Rotation.random(50, seed=3); v = np.arange(150.0).reshape(50, 3)\n"
        "s = Rotation.from_rotvec(3 * r.as_rotvec()) * Rotation.from_euler('ZYX', v, degrees=True)\n"
        "parts = [s.as_matrix(), s.as_euler('zxz'), s.as_mrp(), s.apply(v), (s**0.3).as_quat(),\n"
        "    Rotation.from_matrix(s.as_matrix()).as_quat(canonical=True), rotate(v, v + 1, v[:, 0]),\n"
        "    rotate_euler(v, v), s.mean().as_quat()]\n"
        "print(builtins.available(), *[x.hex() for p in parts for x in p.ravel().tolist()])"
    )
    compiled, plain = (run(code, NUMBA_DISABLE_JIT=flag).split() for flag in ("0", "1"))
    assert (compiled[0], plain[0]) == ("True", "False")
    a, b = ([float.fromhex(x) for x in found[1:]] for found in (compiled, plain))
    np.testing.assert_allclose(a, b, rtol=1e-13, atol=1e-13)


@pytest.mark.slow
def test_few_rotations_and_points_import_no_numba(tmp_path: Path) -> None:
    code = (
        "import sys, numpy as np\n"
        "from rotation import Rotation, rotate, rotate_euler, rotate_quat, slerp, align\n"
        "r = Rotation.random(10_000, seed=1); v = np.ones((10_000, 3))\n"
        "r.apply(v); r[0].apply(v); r.as_matrix(); r.as_rotvec(); r.as_euler('ZYX'); (r * r).inv()\n"
        "v32 = np.ones((10_000, 3), np.float32); r.apply(v32); r.apply(v, out=v); slerp(r, r[0], 0.5)\n"
        "rotate(v, v, v[:, 0]); rotate_quat(v.T, [1, 2, 3, 4], layout='soa'); rotate_euler(v, v)\n"
        "rotate_quat(v, [1, 2, 3, 4], out=v); align(v[:9], r[0].apply(v[:9])); r.mean()\n"
        "print('numba' in sys.modules)"
    )
    assert run(code, NUMBA_CACHE_DIR=str(tmp_path)) == "False"
    assert list((tmp_path / disk_cache.FOLDER).iterdir())


def test_a_program_rounds_as_numpy_does() -> None:
    q = RNG.standard_normal((1000, 4)) * 10.0 ** RNG.uniform(-300, 300, (1000, 1))
    np.testing.assert_array_equal(Rotation(q).as_quat(), quiet(normalise)(q))


# --- what the builtins take, and what they make ---------------------------------------------------

compiled = pytest.mark.skipif(not builtins.available(), reason="there is no machine code")


class Marked(Rotation):
    """A subclass with more to hold than a rotation."""

    note = "none"


@compiled
def test_a_rotation_is_made_whole_and_of_the_class_of_the_left_one() -> None:
    r, m = Rotation(UNITS[0]), Marked(UNITS[:5])
    r * r, m * m  # compiled
    for made, kind, shape in (
        (r * r, Rotation, ()),
        (m * r, Marked, (5,)),
        (r * m, Rotation, (5,)),
        (m.inv(), Marked, (5,)),
        (m**0.3, Marked, (5,)),
    ):
        q = made._q
        assert type(made) is kind
        assert made.shape == shape
        assert type(q) is np.ndarray
        assert q.flags.owndata
        assert not q.flags.writeable
        assert q.base is None
        assert weakref.ref(made)() is made
        assert gc.is_tracked(made)
        again = pickle.loads(pickle.dumps(made))
        assert type(again) is kind
        assert (again._q == q).all()
    made = m.inv()
    made.__dict__["note"] = "some"
    assert made.note == "some"
    assert Marked.note == "none"


@compiled
def test_what_a_builtin_does_not_take_is_answered_by_none() -> None:
    product, power = PRODUCT, SHORTER_POWER
    p = UNITS[:6]
    product(p, p), power(p, np.float64(0.3))  # compiled
    f, g = product.function, power.function
    assert (f(None, p, p) == _product(p, p)).all()
    assert (f(None, p, p[0]) == _product(p, p[0])).all()
    assert (g(None, p, 0.3) == g(None, p, np.array(0.3))).all()
    wrong: list[tuple[Any, ...]] = [
        (p,),
        (p, p, p),
        (p, p[:5]),
        (p, p[:1]),
        (p, p[:, None]),
        (p, p[:, :3]),
        (p[::2], p[:3]),
        (p.T.copy().T, p),
        (p.astype(np.float32), p),
        (p.astype(">f8"), p),
        (p.view(np.recarray), p),
        (p.tolist(), p),
        (p, None),
        (p, 0.5),
        (p, np.float64(0.5)),
        (p[0, 0], p[0, 0]),
        (p, np.ones((6, 3))),
        (np.ones((6, 8)), p),
        (np.ones(()), p),
    ]
    assert [f(None, *given) for given in wrong] == [None] * len(wrong)
    assert [g(None, p, e) for e in (1, True, np.float32(1), "1", [0.5])] == [None] * 5
    much = np.ones((MUCH // 4 + 1, 4))
    assert f(None, much, p[0]) is None
    assert f(None, much[1:], p[0]) is not None
    assert f(np.empty((6, 3)), p, p) is f(np.empty((5, 4)), p, p) is None
    axes = np.ones((1,) * 63 + (4,))
    assert INVERSE(axes).ndim == INVERSE.function(None, axes).ndim == 64
    with pytest.raises(ValueError, match="64"):
        Rotation(axes).as_matrix()


@compiled
def test_nothing_is_made_of_rows_of_which_something_is_told() -> None:
    formula = RowFormula(normalise, (4,))
    zeros = np.zeros((3, 4))
    formula(UNITS[:3])
    assert formula.function(None, UNITS[:3]) is not None
    assert formula.function(None, zeros) is None
    out = np.ones((3, 4))
    assert formula.function(out, UNITS[:3]) is False
    assert formula.function(out, zeros) is True


@compiled
def test_what_is_made_and_what_is_not_leaves_no_reference_behind() -> None:
    r, formula = Marked(UNITS[:3]), RowFormula(normalise, (4,))
    zeros, one, two = np.zeros((3, 4)), np.ones(4), 7 * UNITS[:2]

    def all_ways() -> None:
        r * r, r.inv(), r**0.3, r.magnitude(), r[0].magnitude()
        formula.with_flag(zeros), PRODUCT(one, two), PRODUCT.function(None, zeros)

    def counts() -> list[int]:
        things = (None, Marked, np.dtype(np.float64), np.ndarray, zeros, one, r._q)
        return [sys.getrefcount(thing) for thing in things]

    all_ways()
    before = counts()
    for _ in range(1000):
        all_ways()
    assert all(abs(a - b) < 200 for a, b in zip(before, counts(), strict=True))
