"""Set or return the number of threads that a call may use."""

from hfield.compiling import threads as pool
from rotation.errors import RotationError


def threads(number: int | None = None) -> int:
    """Set the number of threads of a call to ``number``, if it is given; return the number.

    The initial value is the environment variable ``HFIELD_NUM_THREADS`` or ``ROTATION_NUM_THREADS``, else the
    number of processors available to this process. Raises `RotationError` unless it is an integer of at least
    1.

    Examples
    --------
    >>> threads() >= 1
    True
    """
    try:
        return pool.threads(number)
    except pool.ThreadsError as error:
        raise RotationError(str(error)) from None
