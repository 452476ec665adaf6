"""The base class of `Rotation`: an immutable array of unit quaternions, with its storage and its shape."""

from collections.abc import Iterable, Sequence
from typing import Self, cast

import numpy as np
import numpy.typing as npt

from rotation import hints
from rotation.array_types import Array
from rotation.arrays import precision
from rotation.errors import DTypeError, ForeignArrayError, MemberError, RotationError
from rotation.immutable_arrays import ImmutableArray
from rotation.namespaces import floats, is_numpy, namespace
from rotation.pytrees import known

new, set_quaternions = object.__new__, vars(ImmutableArray)["_q"].__set__


class Batch(ImmutableArray):
    """An array of unit quaternions (…, 4), scalar first."""

    __slots__ = ()
    _called = "rotation"

    @classmethod
    def _of(cls, q: Array) -> Self:
        """Wrap unit quaternions without copying; the caller must not write to them afterwards."""
        self = new(cls)
        if type(q) is np.ndarray or isinstance(q, np.ndarray):
            q.setflags(False)  # type: ignore[call-arg]  # by position: three times as quick
        set_quaternions(self, q)
        return known(self)

    @classmethod
    def _stored(cls, q: Array, dtype: npt.DTypeLike | None) -> Self:
        """Wrap unit quaternions in the given precision; if it is None, in their own."""
        if dtype is None:
            return cls._of(q)
        kind = precision(dtype)
        if not is_numpy(namespace(q)):
            raise ForeignArrayError(
                f"dtype is for numpy arrays; those of {namespace(q).__name__} keep their precision, so "
                "convert them before"
            )
        return cls._of(q.astype(kind, copy=False))

    def _alike(self, q: Array) -> Self:
        """Wrap unit quaternions computed from `_double`, in the precision of this object."""
        if q.dtype is self._q.dtype:
            return self._of(q)
        return self._stored(q, self._q.dtype) if is_numpy(namespace(q)) else self._of(q)

    @property
    def _double(self) -> Array:
        """The quaternions; numpy arrays as float64."""
        return floats(self._q, "rotations")

    @property
    def dtype(self) -> "np.dtype[np.floating]":
        """The floating point type of the stored quaternions and of results."""
        return self._q.dtype

    def astype(self, dtype: npt.DTypeLike | None) -> Self:
        """Return the same rotations stored in float32 or float64, each coordinate rounded once.

        Rotations in float32 take half the memory; storing a rotation changes it by at most 2⁻²³ radians.
        Everything computed from them, including products, powers and means, is computed in double precision
        and rounded once to float32. Matrix entries are accurate to 2⁻²⁴, and all numbers x to ``2⁻²³·max(1,
        |x|)``. Products with rotations in float64 are in float64; rotated points have the dtype of the
        points. Motions and curves are in float64.

        Raises
        ------
        DTypeError
            Another type.
        ForeignArrayError
            Arrays that are not numpy's: these keep the precision they have.

        Examples
        --------
        >>> from rotation import Rotation
        >>> r = Rotation.from_euler("Z", 90, degrees=True).astype(np.float32)
        >>> (r * r).as_quat()
        array([0., 0., 0., 1.], dtype=float32)
        """
        return self._stored(self._q, dtype)

    def reshape(self, *shape: int | Sequence[int]) -> Self:
        """Return the same rotations in another batch shape; one axis may be −1."""
        lengths = shape[0] if len(shape) == 1 and isinstance(shape[0], Sequence) else shape
        wanted = cast(Sequence[int], lengths)
        if min(wanted, default=0) < -1:
            raise RotationError(f"the shape {tuple(wanted)} has a negative length")
        if -1 in wanted:  # counted without the axis of four, so that no quaternion is cut
            known = int(np.prod([n for n in wanted if n != -1], dtype=np.int64))
            wanted = tuple(self.size // max(known, 1) if n == -1 else n for n in wanted)
        if int(np.prod(wanted, dtype=np.int64)) != self.size:
            raise RotationError(f"{self.size} rotations do not fit the shape {tuple(wanted)}")
        return self._of(namespace(self._q).reshape(self._q, (*wanted, 4)))

    def __getitem__(self, index: object) -> Self:
        index = index if isinstance(index, tuple) else (index,)
        if self.single and not all(i is None or i is Ellipsis for i in index):
            raise TypeError("a single rotation cannot be indexed")
        if len(index) == 1 and hasattr(index[0], "dtype"):
            xp = namespace(self._q)  # in the array API a mask stands alone
            if not is_numpy(xp) and xp.isdtype(index[0].dtype, "bool"):
                return self._of(self._q[index[0]])
        if not any(i is Ellipsis for i in index):
            index = (*index, Ellipsis)
        return self._of(self._q[(*index, slice(None))])

    @classmethod
    def concatenate(cls, rotations: "Batch | Iterable[Batch]") -> Self:
        """Join rotations along their first axis; a single rotation counts as a batch of one.

        Raises
        ------
        RotationError
            There are no arrays, or their other axes differ.
        MemberError
            Something among them is not a rotation; it is a DTypeError and a RotationError.
        """
        if not isinstance(rotations, Batch | Iterable):
            raise MemberError(
                f"concatenate takes rotations, one after the other, not {hints.described(rotations)}"
            )
        members = [rotations] if isinstance(rotations, Batch) else list(rotations)
        if not members:
            raise RotationError("concatenate takes at least one Rotation")
        for n, r in enumerate(members):
            if not isinstance(r, Batch):
                refusal = hints.refusal(r, f"number {n}", "Rotation")
                raise MemberError(f"concatenate takes rotations; {refusal}")
        xp = namespace(*(r._q for r in members))
        parts = [r._q[None, :] if r.single else r._q for r in members]
        if len({part.shape[1:] for part in parts}) > 1:
            shapes = ", ".join(str(r.shape) for r in members)
            raise RotationError(f"batch shapes differ beyond the first axis: {shapes}")
        return cls._of(xp.concat(parts, axis=0))

    def __repr__(self) -> str:
        array = (
            str(self._q)
            if not is_numpy(namespace(self._q))
            else np.array2string(
                self._q, separator=", ", prefix="Rotation.from_quat(", threshold=40
            )
        )
        plain = isinstance(self._q, np.ndarray)
        kind = ", dtype='float32'" if plain and self._q.dtype == np.float32 else ""
        return f"Rotation.from_quat({array}{kind})"

    def _repr_html_(self) -> str | None:
        from rotation.html_table import table

        return table(self._q)

    def __reduce__(self) -> tuple[object, ...]:
        return _restore, (type(self), self._q)


def expect_rotations(**named: object) -> None:
    """Raise `DTypeError` unless all values are rotations, rather than quaternions or matrices."""
    for name, value in named.items():
        if not isinstance(value, Batch):
            raise DTypeError(hints.refusal(value, name, "Rotation"))


def _restore(cls: type[Batch], q: Array) -> Batch:
    """Rebuild from a pickle without normalising again."""
    return cls._of(q)
