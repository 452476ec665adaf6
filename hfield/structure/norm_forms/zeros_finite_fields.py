"""Zero norms over finite fields, where there always are some, written down and not searched for."""

from hfield.errors import UndecidedError
from hfield.product import Constants, Coordinates
from hfield.rings.base import Ring


def zero_norm_finite(ring: Ring, c: Constants) -> Coordinates:
    """Return a nonzero element of norm 0 of a nondegenerate algebra over GF(q), in O(log q) steps.

    In even characteristic every element is a square and ``N(i + s·j) = −a − b·s²``. In odd
    characteristic a product of two non-squares is a square, and a non-square is a sum of two squares.
    """
    a, t, b = c
    zero, one = ring.zero, ring.one
    if ring.characteristic == 2:
        return zero, one, _root(ring, ring.divide(a, b)), zero
    half = ring.inverse(ring(2))
    shift = t * half
    a = a + shift * shift  # the square of i − t/2
    root = ring.sqrt(a)
    if root is not None:
        return root - shift, one, zero, zero
    root = ring.sqrt(b)
    if root is not None:
        return root, zero, one, zero
    # a and b are non-squares: b = a·s², and 1/a = x² + y² gives a·(a·x)² + b·(a·y/s)² = a²
    s = _root(ring, ring.divide(b, a))
    target = ring.inverse(a)
    for x in ring.elements():
        y = ring.sqrt(target - x * x)
        if y is not None:
            u, v = a * x, ring.divide(a * y, s)
            return a - shift * u, u, v, zero
    raise UndecidedError(
        f"{ring.name} has a non-square that is no sum of two squares: not a field?"
    )


def _root(ring: Ring, x: object) -> object:
    root = ring.sqrt(x)
    if root is None:
        raise UndecidedError(
            f"{ring.name} gave no square root of {ring.text(x)}, which must have one"
        )
    return root
