"""Numbers of sympy wherever numbers are taken: the nearest floats, and an error for what is not real."""

import subprocess
import sys

import mpmath
import numpy as np
import pytest
import sympy

from rotation import (
    R2,
    DTypeError,
    R_x,
    Rotation,
    rotate,
    rotate2,
    rotate_euler,
    rotate_quat,
    slerp,
)
from tests.patience import PATIENCE

THIRD = sympy.pi / 3
with mpmath.workdps(40):
    NEAREST = float(mpmath.pi / 3)  # np.pi / 3 is the float below it
Z = [0, 0, 1]
CALLS = {
    "from_rotvec": lambda a: Rotation.from_rotvec([0, 0, a]).as_quat(),
    "from_euler": lambda a: Rotation.from_euler("ZYX", [a, a, 0]).as_quat(),
    "from_euler, one letter": lambda a: Rotation.from_euler("z", a).as_quat(),
    "from_axis_angle": lambda a: Rotation.from_axis_angle(Z, a).as_quat(),
    "from_mrp": lambda a: Rotation.from_mrp([a, 0, 0]).as_quat(),
    "power": lambda a: (Rotation.from_euler("x", 1.0) ** a).as_quat(),
    "plus": lambda a: Rotation.identity().plus([a, 0, 0]).as_quat(),
    "slerp": lambda a: slerp(Rotation.identity(), Rotation.from_euler("x", 1.0), a).as_quat(),
    "R_x": R_x,
    "R2": R2,
    "rotate": lambda a: rotate([[1, 2, a]], [0, a, 1], a),
    "rotate, degrees": lambda a: rotate([1, 2, 3], Z, a, degrees=True),
    "rotate2": lambda a: rotate2([[1, a]], a),
    "rotate_euler": lambda a: rotate_euler([1, 2, 3], [a, 1, 0]),
    "rotate_quat": lambda a: rotate_quat([1, 2, 3], [a, 1, 0, 0]),
    "apply": lambda a: Rotation.from_euler("x", 1.0).apply([a, 0, 1]),
}


@pytest.mark.parametrize("name", CALLS)
def test_a_number_of_sympy_is_the_nearest_float(name):
    assert np.array_equal(CALLS[name](THIRD), CALLS[name](NEAREST))


def test_every_number_is_rounded_to_the_nearest_float():
    exact = [sympy.sqrt(n) * sympy.pi**k / 7 for n in range(2, 40) for k in (-30, -1, 0, 1, 30)]
    exact += [sympy.pi - sympy.Rational(355, 113), sympy.exp(-700), sympy.Integer(10) ** 200 + 1]
    with mpmath.workdps(60):
        nearest = [float(sympy.lambdify((), e, "mpmath")()) for e in exact]
    assert rotate2([[e, 0] for e in exact], 0)[:, 0].tolist() == nearest


def test_matrices_of_sympy_and_arrays_of_objects():
    corners = sympy.Matrix([[1, sympy.sqrt(2)], [0, 3]])
    assert np.array_equal(rotate2(corners, 0), [[1, 2**0.5], [0, 3]])
    angles = np.array([sympy.pi, 1, 0.5], dtype=object)
    assert np.array_equal(R2(angles), R2([np.pi, 1, 0.5]))


def test_in_arrays_of_other_libraries():
    xp = pytest.importorskip("array_api_strict")
    r = Rotation.from_axis_angle(xp.asarray([0.0, 0.0, 1.0]), THIRD)
    assert np.allclose(np.asarray(r.as_quat()), [0.75**0.5, 0, 0, 0.5], rtol=0, atol=1e-15)


@pytest.mark.parametrize(
    ("angle", "said"),
    [
        (sympy.Symbol("t"), "symbol t in t; give it a value"),
        (2 * sympy.Symbol("t") + sympy.Symbol("u"), r"\.subs\('t', 1\)"),
        (sympy.I, "angle has I; expected a real number"),
        (sympy.zoo, "expected a real number"),
        (sympy.true, "expected an array of numbers"),
        (sympy.Quaternion(1, 0, 0, 0), "expected a real number"),
        ([sympy.pi, "1"], "dtype"),
    ],
)
def test_what_is_no_real_number_is_named(angle, said):
    with pytest.raises(DTypeError, match=said):
        rotate([1, 0, 0], Z, angle)


def test_objects_of_other_kinds_are_refused_as_before():
    from fractions import Fraction

    for angle in (Fraction(1, 3), np.array([1, 2], dtype=object), [THIRD, Fraction(1, 3)]):
        with pytest.raises(DTypeError):
            rotate([1, 0, 0], Z, angle)


@pytest.mark.slow
def test_sympy_is_not_imported_to_tell():
    code = (
        "import sys, numpy, rotation\n"
        "try: rotation.rotate([1, 0, 0], [0, 0, 1], numpy.array(1, dtype=object))\n"
        "except TypeError: pass\n"
        "assert 'sympy' not in sys.modules"
    )
    subprocess.run([sys.executable, "-c", code], check=True, timeout=PATIENCE)
