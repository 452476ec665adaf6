"""The errors of the package; each is both an `HFieldError` and a builtin error."""

from hfield.errors import HFieldError


class RotationError(HFieldError, ValueError):
    """An error for values that are not rotations, or for incompatible shapes, layouts or memory.

    Examples
    --------
    >>> from rotation import Rotation
    >>> try:
    ...     Rotation.from_quat([0, 0, 0, 0])
    ... except RotationError as error:
    ...     print(type(error).__name__)
    ZeroRotationError
    """


class ZeroRotationError(RotationError):
    """A zero axis or zero quaternion, which has no direction. ``row`` is its index in the batch.

    Examples
    --------
    >>> from rotation import Rotation
    >>> try:
    ...     Rotation.from_quat([0, 0, 0, 0])
    ... except ZeroRotationError:
    ...     print("no direction")
    no direction
    """

    def __init__(self, name: str, row: tuple[int, ...]) -> None:
        self.row = row
        where = "" if not row else f" in row {row[0] if len(row) == 1 else row}"
        super().__init__(
            f"zero {name}{where}: it names no rotation; give a nonzero one, of any length"
        )


class DTypeError(HFieldError, TypeError):
    """An array of an unsupported kind, such as complex numbers, booleans or objects.

    Examples
    --------
    >>> issubclass(DTypeError, TypeError)
    True
    """


class MemberError(DTypeError, RotationError):
    """A value of the wrong type in a list of rotations."""


class ArgumentError(HFieldError, TypeError):
    """An unknown argument, such as one of scipy's names; the message says what to write.

    Examples
    --------
    >>> from rotation import Rotation
    >>> Rotation.random(3, random_state=1)
    Traceback (most recent call last):
    ...
    rotation.errors.ArgumentError: random has no argument random_state: write seed=1
    """


class ForeignArrayError(HFieldError, TypeError):
    """An array of another library where only numpy arrays are supported.

    Examples
    --------
    >>> issubclass(ForeignArrayError, TypeError)
    True
    """
