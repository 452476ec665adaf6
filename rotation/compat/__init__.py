"""A drop-in replacement of scipy's rotations: its names, order of coordinates, item assignment, warnings.

``from rotation.compat import Rotation`` in place of ``from scipy.spatial.transform import Rotation``; the
arithmetic is ours. docs/how-to/coming-from-scipy.md lists what differs.
"""

from rotation.compat.curves import RotationSpline, Slerp
from rotation.compat.rotations import Rotation
from rotation.compat.transforms import RigidTransform

__all__ = ["RigidTransform", "Rotation", "RotationSpline", "Slerp"]
