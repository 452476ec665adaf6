"""Running products of many rotations, each of norm 1 to rounding."""

from rotation import kernels, quaternions
from rotation.array_types import Array
from rotation.errors import RotationError
from rotation.namespaces import is_numpy, namespace

_DOUBLED_PRODUCTS = 1000  # products; doubling them loses at most one digit


def running_products(q: Array, frame: str) -> Array:
    """Return the products of unit quaternions (n, …, 4) up to each one along the first axis.

    With ``frame="world"`` they are ``q[n]·…·q[0]``, with ``frame="body"`` ``q[0]·…·q[n]``. A long numpy array
    of single quaternions uses a compiled loop; all others use doubling: products of 2, 4, 8, … neighbours.

    Raises
    ------
    RotationError
        A single quaternion, or another frame.
    """
    check_frame(frame)
    if q.ndim < 2:
        raise RotationError("a single rotation has no running products; a batch is expected")
    xp = namespace(q)
    if is_numpy(xp) and q.ndim == 2 and len(q) > _DOUBLED_PRODUCTS:
        if frame == "world":
            return kernels.cumulative(q)
        # Conjugation turns products round.
        return quaternions.inverse(kernels.cumulative(quaternions.inverse(q)))
    reach = 1
    while reach < q.shape[0]:
        later, earlier = q[reach:, ...], q[:-reach, ...]
        pair = (later, earlier) if frame == "world" else (earlier, later)
        q = xp.concat([q[:reach, ...], quaternions.product(*pair)], axis=0)
        reach *= 2
    return q


def check_frame(frame: str) -> None:
    """Raise RotationError unless ``frame`` is a valid name of a frame."""
    if frame not in ("body", "world"):
        raise RotationError(f'frame {frame!r}: "body" or "world" is expected')
