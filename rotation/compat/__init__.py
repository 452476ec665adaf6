"""A drop-in replacement for scipy's rotations: same names, order of coordinates, item assignment, warnings.

Write ``from rotation.compat import Rotation`` instead of ``from scipy.spatial.transform import Rotation``.
The arithmetic is that of this package. docs/how-to/coming-from-scipy.md lists the differences.
"""

from rotation.compat.curves import RotationSpline, Slerp
from rotation.compat.rotations import Rotation
from rotation.compat.transforms import RigidTransform

__all__ = ["RigidTransform", "Rotation", "RotationSpline", "Slerp"]
