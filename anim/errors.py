"""The errors of the package: shapes, motions, pictures."""

from hfield.errors import HFieldError


class AnimationError(HFieldError, ValueError):
    """A shape, a motion or a film that cannot be made from the values given.

    >>> from anim import Camera
    >>> try:
    ...     Camera(zoom=0)
    ... except AnimationError as error:
    ...     print(error)
    the camera's zoom is 0; expected a number greater than 0
    """
