"""Check and convert array arguments: dtype, layout, shape, memory.

``layout="aos"`` (array of structures) keeps the components last: points ``(…, 3)``, quaternions
``(…, 4)``. ``layout="soa"`` (structure of arrays) keeps them first: ``(3, …)`` and ``(4, …)``. The other
axes are the batch; batches broadcast by numpy's rules.
"""

import sys
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from hfield.errors import shorten
from rotation import hints
from rotation.array_types import Array
from rotation.errors import DTypeError, ForeignArrayError, RotationError, ZeroRotationError

if TYPE_CHECKING:
    import sympy

Layout = Literal["aos", "soa"]
Shape = tuple[int, ...]

_AXES = {"x": "[1, 0, 0]", "y": "[0, 1, 0]", "z": "[0, 0, 1]"}
_NUMBERS = (np.ndarray, np.generic, list, tuple, int, float)
_DIGITS = 30  # of sympy's numbers, before they are rounded to floats
_OVERLAP_WORK = 10_000  # candidates tried for an exact answer; a harder question counts as overlap


def real(value: object, name: str) -> Array:
    """Return ``value`` as a native float32 or float64 array; integers and sympy's numbers become float64.

    The array is copied only if necessary. Raises `DTypeError` for other kinds (complex, bool, object, text,
    half and extended precision), `ForeignArrayError` for arrays of other libraries, and `RotationError` for
    ragged lists and masked arrays.
    """
    if type(value) is np.ndarray and value.dtype.char in "fd" and value.dtype.isnative:
        return value
    if not isinstance(value, np.ndarray | np.generic) and hasattr(value, "__dlpack__"):
        kind = f"{type(value).__module__.partition('.')[0]}.{type(value).__name__}"
        raise ForeignArrayError(
            f"{name} is a {kind}, and this call takes numpy arrays only; "
            "Rotation.apply works on arrays of other libraries"
        )
    if not isinstance(value, _NUMBERS):
        expect_numbers(value, name)
    expect_unmasked(value, name)
    try:
        array = np.asarray(value)
    except ValueError as error:
        raise RotationError(f"{name} is not a rectangular array: {error}") from error
    if array.dtype.kind in "iu":
        return array.astype(np.float64)
    if array.dtype.kind == "f" and array.dtype.itemsize in (4, 8):
        return array.astype(array.dtype.newbyteorder("="), copy=False)
    if array.dtype.name == "quaternion":  # numpy-quaternion's: four floats, scalar first
        return array.reshape(-1).view(np.float64).reshape(*array.shape, 4)
    if array.dtype.kind == "O":
        expect_numbers(value, name)
        numbers = _from_sympy(array, name)
        if numbers is not None:
            return numbers
        if not isinstance(value, _NUMBERS):
            raise DTypeError(f"{name} is {hints.described(value)}; expected an array of numbers")
    if isinstance(value, str) and value.lower() in _AXES:
        raise DTypeError(f"{name} is {value!r}; write {_AXES[value.lower()]} for that axis")
    if isinstance(value, str):
        raise DTypeError(f"{name} is the text {value!r}; expected numbers, such as [0, 0, 1]")
    raise DTypeError(
        f"{name} has dtype {array.dtype}; expected float32, float64 or integers: "
        f"convert with .astype(np.float64) where that is what you mean"
    )


def _from_sympy(array: Array, name: str) -> Array | None:
    """Return an array of sympy numbers as float64, each rounded to the nearest float; None for other objects.

    Python numbers may be mixed in. sympy is not imported for the test. Raises `DTypeError` for symbols and
    for numbers that are not real.
    """
    sympys = getattr(sys.modules.get("sympy"), "Expr", ())
    entries = array.reshape(-1).tolist()
    if not any(isinstance(entry, sympys) for entry in entries):
        return None
    if not all(isinstance(entry, (sympys, int, float)) for entry in entries):
        return None
    numbers = [_float(e, name) if isinstance(e, sympys) else float(e) for e in entries]
    return np.array(numbers, np.float64).reshape(array.shape)


def _float(number: "sympy.Expr", name: str) -> float:
    """Return a sympy number as the nearest float."""
    if number.free_symbols:
        symbol = min(map(str, number.free_symbols))
        raise DTypeError(
            f"{name} has the symbol {symbol} in {shorten(number)}; give it a value, as by "
            f".subs({symbol!r}, 1)"
        )
    try:
        return float(number.evalf(_DIGITS))
    except TypeError:
        raise DTypeError(f"{name} has {shorten(number)}; expected a real number") from None


def precision(dtype: object) -> "np.dtype[Any]":
    """Return float32 or float64, the types in which rotations are stored; raises `DTypeError` for anything
    else.
    """
    try:
        kind: np.dtype[Any] = np.dtype(dtype)  # type: ignore[call-overload]
    except TypeError:
        kind = np.dtype(object)
    if kind not in (np.float32, np.float64):
        raise DTypeError(f"dtype {dtype!r}: rotations are stored in np.float32 or np.float64")
    return kind


def expect_numbers(value: object, name: str) -> None:
    """Raise `DTypeError` for a rotation or a transform if an array is expected."""
    refusal = hints.numbers_expected(value, name)
    if refusal is not None:
        raise DTypeError(refusal)


def expect_unmasked(value: object, name: str) -> None:
    """Raise `RotationError` for a masked array, or a list that contains one; numpy.ma is not imported for
    this.
    """
    masked = getattr(sys.modules.get("numpy.ma"), "MaskedArray", None)  # or a thread imports it now
    if masked is not None and _contains(value, masked):
        raise RotationError(
            f"{name} is a masked array, whose mask would be lost; give its .filled(np.nan)"
        )


def _contains(value: object, kind: type) -> bool:
    if isinstance(value, list | tuple):
        return any(_contains(member, kind) for member in value)
    return isinstance(value, kind)


def components(value: object, number: int, name: str, layout: Layout) -> Array:
    """Return ``value`` as a float array with its ``number`` components last.

    The result for ``layout="soa"`` is a view with the first axis moved to the end. Raises as `real` does, and
    `RotationError` if the axis of components has another length.
    """
    array = real(value, name)
    axis = component_axis(layout)
    if array.ndim == 0 or array.shape[axis] != number:
        expected = f"(…, {number})" if layout == "aos" else f"({number}, …)"
        hint = ""
        if array.ndim and array.shape[-1 - axis] == number:
            hint = f'; it would fit layout="{"soa" if layout == "aos" else "aos"}"'
        raise RotationError(
            f'{name} has shape {array.shape}; expected {expected} for layout="{layout}"{hint}'
        )
    return components_last(array, layout)


def component_axis(layout: Layout) -> int:
    """Return the axis of the components: −1 or 0. Raises `RotationError` for an unknown layout."""
    if layout not in ("aos", "soa"):
        raise RotationError(f'layout is {layout!r}; expected "aos" for (…, 3) or "soa" for (3, …)')
    return -1 if layout == "aos" else 0


def components_last(array: Array, layout: Layout) -> Array:
    """Return the view of ``array`` with the axis of components at the end."""
    return array if layout == "aos" else array.transpose(*range(1, array.ndim), 0)


def common_batch(**batches: Shape) -> Shape:
    """Return the shape to which the given batch shapes broadcast. Raises `RotationError`, with the names of
    the arguments, if they do not.
    """
    widest = max(batches.values(), key=len)
    if all(shape in ((), widest) for shape in batches.values()):
        return widest
    try:
        return np.broadcast_shapes(*batches.values())
    except ValueError:
        shapes = ", ".join(f"{name} {shape}" for name, shape in batches.items())
        raise RotationError(
            f"batch shapes do not broadcast: {shapes}; they must agree or be 1, axis by axis"
        ) from None


def destination(
    out: object, batch: Shape, points: Array, others: tuple[Array, ...], layout: Layout
) -> tuple[Array, Array]:
    """Return the result array (``out`` after checks, or a new one) and its view with components last.

    ``points`` and ``others`` are the arrays that will be read. ``out`` may be the points themselves. Any
    other overlap, another dtype or shape, or read-only memory raises an error before anything is written.
    """
    shape = (*batch, 3) if layout == "aos" else (3, *batch)
    if out is None:
        new = np.empty(shape, points.dtype)
        return new, components_last(new, layout)
    expect_unmasked(out, "out")
    if not isinstance(out, np.ndarray):
        raise DTypeError(f"out is a {type(out).__name__}; expected a numpy array")
    if out.dtype != points.dtype:
        raise DTypeError(
            f"out has dtype {out.dtype.str}; expected {points.dtype.str}, as the points decide it"
        )
    if out.shape != shape:
        raise RotationError(f"out has shape {out.shape}; expected {shape}")
    if not out.flags.writeable:
        raise RotationError("out is read-only; give an array that can be written")
    moved = components_last(np.asarray(out), layout)
    if _overlaps_itself(moved):
        raise RotationError("out overlaps itself: several rows share memory; give a copy of it")
    if _overlap(moved, points) and not _same(moved, points):
        raise RotationError(
            "out overlaps the points in part; give the points themselves, or separate memory"
        )
    if any(_overlap(moved, other) for other in others):
        raise RotationError("out overlaps the axes, angles or quaternions; give separate memory")
    return out, moved


def require_nonzero(array: Array, name: str) -> None:
    """Raise `ZeroRotationError` with the index of the first row of ``array`` whose components are
    all zero.
    """
    if array.all():  # as most are
        return
    zero = ~array.any(axis=-1)
    if zero.any():
        raise ZeroRotationError(name, tuple(int(i) for i in np.argwhere(zero)[0]))


def _same(a: Array, b: Array) -> bool:
    same_memory = a.__array_interface__["data"][0] == b.__array_interface__["data"][0]
    return same_memory and a.shape == b.shape and a.strides == b.strides


def _overlap(a: Array, b: Array) -> bool:
    if not np.may_share_memory(a, b):
        return False
    try:
        # numpy's stubs know only the two special values of max_work
        return np.shares_memory(a, b, max_work=_OVERLAP_WORK)  # type: ignore[arg-type]
    except np.exceptions.TooHardError:
        return True


def _overlaps_itself(a: Array) -> bool:
    """Return False only if every stride exceeds the range of the smaller ones, which excludes overlap."""
    if a.flags.forc:
        return False
    reach = a.itemsize
    for stride, length in sorted(
        (abs(s), n) for s, n in zip(a.strides, a.shape, strict=True) if n > 1
    ):
        if stride < reach:
            return a.size > 0
        reach += stride * (length - 1)
    return False
