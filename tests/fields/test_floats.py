"""RDF: finite floats, and nothing proved with them."""

import numpy as np
import pytest

from hfield.errors import CoercionError, HFieldError, NotInvertibleError
from hfield.fields import RDF
from tests.subcases import subcases


def test_values_enter():
    assert RDF("1/3") == 1 / 3
    assert RDF("sqrt(2)/2") == 2**0.5 / 2
    assert RDF("cos(pi/3)") == pytest.approx(0.5)
    assert RDF(np.float32(0.5)) == 0.5
    assert RDF(2**60) == float(2**60)
    assert isinstance(RDF(np.float64(1)), float)


@subcases(
    "x", [float("nan"), float("inf"), -float("inf"), "nan", "inf", "-inf", "1e999", 2**2000, 1j, "1/0",
          "sqrt(-1)", "log(0)", "exp(1000)", None, np.float64("nan")],
)  # fmt: skip
def test_what_is_not_finite_is_refused(x):
    with pytest.raises(HFieldError):
        RDF(x)


def test_nan_is_named():
    with pytest.raises(
        CoercionError, match="nan is not an element of RDF: expected a finite float64"
    ):
        RDF(float("nan"))
    with pytest.raises(CoercionError, match=r"nan at index \(1,\)"):
        RDF.array(np.array([1.0, np.nan]))
    with pytest.raises(CoercionError):
        RDF.array([1.0, float("inf")])
    with pytest.raises(CoercionError):
        RDF.array(np.array(["a"]))
    with pytest.raises(CoercionError):
        RDF.array(np.array([1j]))


@pytest.mark.parametrize("x", [0.1, -1e-300, 5e-324, 1.7976931348623157e308, 1 / 3, -0.0, 1e22])
def test_texts_read_back(x):
    assert RDF(RDF.text(x)) == x
    assert RDF(RDF.text(x, "unicode")) == x


def test_floats_prove_nothing():
    assert not RDF.is_exact
    assert RDF.level.value is None
    assert RDF.orderings.value is None
    assert "RR is exact" in RDF.level.reason


def test_division():
    with pytest.raises(NotInvertibleError):
        RDF.inverse(0.0)
    with pytest.raises(NotInvertibleError):
        RDF.inverse(5e-324)
    with pytest.raises(NotInvertibleError):
        RDF.power(0.0, -1)
    with pytest.raises(CoercionError):
        RDF.power(10.0, 400)


def test_arrays_are_numpys():
    a = RDF.array([1, "1/2", 0.25])
    assert type(a) is np.ndarray
    assert a.dtype == np.float64
    assert RDF.array(a) is a
    assert isinstance(RDF.scalar(a[0]), float)
