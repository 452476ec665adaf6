"""Run formulas on the rows of arrays, as machine code if possible, else in the array library.

A formula of a hundred operations on numpy arrays needs a hundred calls, and on long arrays a hundred passes
over memory. `RowFormula` compiles it on first use, in some hundredths of a second, to one loop over rows, for
one rotation or a million. For arrays of other libraries the formula is called directly.

Numbers in single precision are converted to double, and the result is rounded once. It is in single precision
if all arrays are. Each combination of precisions has its own loop.
"""

import itertools
from collections.abc import Callable
from math import prod

import numpy as np

from hfield.compiling import machine_code
from hfield.compiling.memory import POOLED_BYTES, block, in_one_piece
from hfield.compiling.threads import in_pieces
from rotation.array_types import NUMPY, Array, Namespace
from rotation.immutable_arrays import ImmutableArray
from rotation.namespaces import quiet
from rotation.native import builtins, tensors
from rotation.native.entry import MUCH
from rotation.thread_count import threads

_ROWS = 16384  # a piece: it stays in the processor's cache
_WORTH = 750_000  # nanoseconds of work that pay for a thread
_ROW, _STEP = 1.0, 0.016  # nanoseconds for a row, and for each of its steps, to within a half
_FLOAT32, FLOAT64 = np.dtype(np.float32), np.dtype(np.float64)
_WORDS = {_FLOAT32: "float", FLOAT64: "double"}

Kinds = tuple[np.dtype[np.floating], ...]


def compile_all() -> None:
    """Compile every existing formula."""
    for formula in _made:
        formula._compiled()


class RowFormula:
    """A function of rows of numbers, ``formula(*arrays, *parameters)``, which treats each row separately.

    Parameters
    ----------
    formula : callable
        Written against the namespace of its arguments, without a branch on their values.
    *shapes : tuple of int
        Of one row of each array.
    parameters : tuple
        What is the same for all rows, and no array.
    single : tuple of int
        Which of the arrays always have one row: it is read once for all rows of the others.
    kinds : tuple of dtypes, optional
        The types in which the arrays are stored, by default all double; for other types the formula creates
        further instances.

    Attributes
    ----------
    function : callable
        ``function(where, *arrays)``: the machine code (see `builtins.compile_builtin`), once it is compiled.
        It returns None for arguments that it cannot take; then the formula is called.
    """

    __slots__ = (
        "_axes",
        "_formula",
        "_kind",
        "_kinds",
        "_others",
        "_parameters",
        "_row",
        "_shapes",
        "_shortest",
        "_single",
        "function",
    )

    def __init__(
        self,
        formula: Callable[..., Array],
        *shapes: tuple[int, ...],
        parameters: tuple[object, ...] = (),
        single: tuple[int, ...] = (),
        kinds: Kinds | None = None,
    ) -> None:
        self._single = single
        self._kinds = kinds or (FLOAT64,) * len(shapes)
        self._kind = max(self._kinds, key=_size)  # the kind of the result
        self._others: dict[Kinds, RowFormula] = {}
        self._formula, self._shapes, self._parameters = formula, shapes, parameters
        self._axes = tuple(-len(shape) or None for shape in shapes)  # the first axes of a row
        self.function: builtins.BuiltinFunction = unmade
        self._row: tuple[int, ...] = ()
        _made.append(self)

    def __call__(self, *arrays: Array) -> Array:
        """Return the values, of the batch shape that all arrays broadcast to."""
        made = self.function(None, *arrays)
        return self._with_flag(arrays)[0] if made is None else made

    def with_flag(self, *arrays: Array) -> tuple[Array, bool]:
        """Return the values, and whether the formula may have flagged a row (with `flag_if`)."""
        made = self.function(None, *arrays)
        return self._with_flag(arrays) if made is None else (made, False)

    def _with_flag(self, arrays: tuple[Array, ...]) -> tuple[Array, bool]:
        """Apply `with_flag` without machine code."""
        batch: tuple[int, ...] = ()
        for a, axes, kind in zip(arrays, self._axes, self._kinds, strict=True):
            if type(a) is not np.ndarray or a.dtype is not kind:
                return self._with_conversion(arrays)
            own = a.shape[:axes]
            if own != batch:
                batch = np.broadcast_shapes(own, batch) if batch and own else own or batch
        function = self._compiled()
        if function is unmade:
            return self._plainly(arrays), True
        straight, shape = self._straightened(arrays, batch), batch + self._row
        size = prod(shape)
        pooled = size * self._kind.itemsize >= POOLED_BYTES
        out = block(shape, self._kind.str)[0] if pooled else np.empty(shape, self._kind)
        if size > MUCH and prod(batch) > self._shortest:
            flag = self._shared(function, straight, out)
        else:
            flag = function(out, *straight) is True
        return out if out.ndim else out[()], flag

    def _compiled(self) -> builtins.BuiltinFunction:
        """Return the machine code, or `unmade` if it cannot be made."""
        if not builtins.available():
            return unmade
        with machine_code.lock:
            if self.function is unmade:
                function, self._row, steps = builtins.compile_builtin(
                    self._formula,
                    self._shapes,
                    self._parameters,
                    self._single,
                    tuple(_WORDS[kind] for kind in (*self._kinds, self._kind)),
                    vars(ImmutableArray)["_q"],
                )
                self._shortest = int(_WORTH / (_ROW + _STEP * steps))
                self.function = function
        return self.function

    def _straightened(self, arrays: tuple[Array, ...], batch: tuple[int, ...]) -> list[Array]:
        """Return contiguous arrays, each with the batch shape, or with one row and no batch."""
        straight = []
        for a, shape in zip(arrays, self._shapes, strict=True):
            own = a.shape[: a.ndim - len(shape)]
            one = all(n == 1 for n in own)
            straight.append(
                in_one_piece(a.reshape(shape), shape) if one else in_one_piece(a, batch + shape)
            )
        return straight

    def _shared(self, function: builtins.BuiltinFunction, arrays: list[Array], out: Array) -> bool:
        """Compute in blocks that all threads share."""
        rows = out.size // prod(self._row)
        flat = [
            a if a.ndim == len(shape) else a.reshape(rows, *shape)
            for a, shape in zip(arrays, self._shapes, strict=True)
        ]
        moving = [a.ndim > len(shape) for a, shape in zip(arrays, self._shapes, strict=True)]
        result = out.reshape(rows, *self._row)

        def work(start: int, end: int) -> bool:
            piece = slice(start, end)
            pieces = (a[piece] if m else a for a, m in zip(flat, moving, strict=True))
            return function(result[piece], *pieces) is True

        threads()  # a wrong number is an error of ours
        return bool(in_pieces(work, rows, _ROWS, self._shortest, (flat, result)))

    def _with_conversion(self, arrays: tuple[Array, ...]) -> tuple[Array, bool]:
        """Compute on arrays with another layout or of other libraries, such as tensors."""
        if all(isinstance(a, np.ndarray | np.generic) for a in arrays):
            kinds = tuple(_FLOAT32 if a.dtype == _FLOAT32 else FLOAT64 for a in arrays)
            plain = (np.array(a, k, copy=None) for a, k in zip(arrays, kinds, strict=True))
            return self._of(kinds).with_flag(*map(np.asarray, plain))
        if not tensors.readable(arrays) or not builtins.available():
            return self._plainly(arrays), True
        values, flag = self.with_flag(*(a.detach().numpy() for a in arrays))
        return tensors.like(arrays[0], values), flag

    def _of(self, kinds: Kinds) -> "RowFormula":
        """Return the same formula for arrays stored in these float types."""
        if kinds == self._kinds:
            return self
        if kinds not in self._others:
            self._others[kinds] = RowFormula(
                self._formula,
                *self._shapes,
                parameters=self._parameters,
                single=self._single,
                kinds=kinds,
            )
        return self._others[kinds]

    @quiet
    def _plainly(self, arrays: tuple[Array, ...]) -> Array:
        """Compute with the arrays' own library; long numpy arrays piece by piece, always in double
        precision.
        """
        if _FLOAT32 in self._kinds:
            doubles = self._of((FLOAT64,) * len(arrays))
            return doubles._plainly(tuple(a.astype(FLOAT64) for a in arrays)).astype(self._kind)
        parameters = self._parameters
        rows = max(
            int(np.prod(a.shape[: a.ndim - len(shape)], dtype=np.int64))
            for a, shape in zip(arrays, self._shapes, strict=True)
        )
        if rows <= _ROWS or not all(isinstance(a, np.ndarray) for a in arrays):
            return self._formula(*arrays, *parameters)
        own = [a.shape[: a.ndim - len(s)] for a, s in zip(arrays, self._shapes, strict=True)]
        batch = np.broadcast_shapes(*own)
        if any(b not in ((), batch) for b in own):
            return self._formula(*arrays, *parameters)
        flat = [
            a if not b else a.reshape(rows, *s)
            for a, b, s in zip(arrays, own, self._shapes, strict=True)
        ]
        parts = []
        for start in itertools.takewhile(lambda n: n < rows, itertools.count(0, _ROWS)):
            piece = slice(start, start + _ROWS)
            parts.append(
                self._formula(
                    *(a[piece] if b else a for a, b in zip(flat, own, strict=True)), *parameters
                )
            )
        result = np.concatenate(parts)
        return result.reshape(*batch, *result.shape[1:])


def unmade(*_: object) -> None:
    """A placeholder for machine code that is not compiled yet."""


def _size(kind: np.dtype[np.floating]) -> int:
    return kind.itemsize


_made: list[RowFormula] = []


def rarely(
    xp: Namespace,
    condition: Array,
    compute: Callable[[], tuple[Array, ...]],
    usual: tuple[Array, ...],
) -> tuple[Array, ...]:
    """Return ``compute()``, which is needed only where ``condition`` holds, or ``usual`` if it
    holds nowhere.
    """
    if xp is NUMPY:
        return compute() if condition.any() else usual
    branch = getattr(xp, "rarely", None)
    return compute() if branch is None else branch(condition, compute, usual)


def flag_if(xp: Namespace, condition: Array) -> None:
    """Make `RowFormula.with_flag` return True if the condition holds in a row; without machine code it may
    return True in any case."""
    if hasattr(xp, "flag_if"):
        xp.flag_if(condition)
