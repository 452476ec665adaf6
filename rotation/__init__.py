"""Rotations of the plane and of space: the algebra of `hfield` on floats.

A quaternion is (w, x, y, z), whereas scipy uses (x, y, z, w); `rotation.compat` has scipy's names and order.

>>> from rotation import Rotation
>>> top = Rotation.from_euler("ZYX", [90, 0, 90], degrees=True)
>>> top.apply([1, 2, 3]).round(12)
array([3., 1., 2.])
"""

import lazy_loader

import hfield.core.locks  # noqa: F401  # a fork may come while the names below are imported

# The public names are listed once, in the stub next to this file, and imported on first use; numba
# is imported with the first call that needs it.
__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
