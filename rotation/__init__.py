"""Rotations of the plane and of space: the algebra of `hfield` on floats.

>>> from rotation import Rotation
>>> top = Rotation.from_euler("ZYX", [90, 0, 90], degrees=True)
>>> top.apply([1, 2, 3]).round(12)
array([3., 1., 2.])
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from rotation.alignment import align, align_points
    from rotation.conventions import change_of_axes, convert_points, convert_rotation
    from rotation.errors import DTypeError, ForeignArrayError, RotationError, ZeroRotationError
    from rotation.fused import rotate, rotate_euler, rotate_quat
    from rotation.interpolation import Slerp, Squad, slerp, squad
    from rotation.jacobians import inverse_left_jacobian, left_jacobian
    from rotation.kernels.pool import threads
    from rotation.matrices import R_x, R_y, R_z
    from rotation.motion import integrate
    from rotation.plane import R2, reflect2, reflection, rotate2
    from rotation.quaternions import T_q
    from rotation.rigid import RigidTransform, sclerp
    from rotation.rotation import Rotation
    from rotation.screws import Screw
    from rotation.spline import RotationSpline
    from rotation.swing import swing_twist
    from rotation.warming import warm_up

# Where the public names live. They are imported on first use; numba comes with the first call that needs it.
_HOMES = {
    "alignment": ["align", "align_points"],
    "conventions": ["change_of_axes", "convert_points", "convert_rotation"],
    "errors": ["DTypeError", "ForeignArrayError", "RotationError", "ZeroRotationError"],
    "fused": ["rotate", "rotate_euler", "rotate_quat"],
    "interpolation": ["Slerp", "Squad", "slerp", "squad"],
    "jacobians": ["inverse_left_jacobian", "left_jacobian"],
    "kernels.pool": ["threads"],
    "matrices": ["R_x", "R_y", "R_z"],
    "motion": ["integrate"],
    "plane": ["R2", "reflect2", "reflection", "rotate2"],
    "quaternions": ["T_q"],
    "rigid": ["RigidTransform", "sclerp"],
    "rotation": ["Rotation"],
    "screws": ["Screw"],
    "spline": ["RotationSpline"],
    "swing": ["swing_twist"],
    "warming": ["warm_up"],
}
_HOME_OF = {name: module for module, names in _HOMES.items() for name in names}

__all__ = [
    "R2",
    "DTypeError",
    "ForeignArrayError",
    "R_x",
    "R_y",
    "R_z",
    "RigidTransform",
    "Rotation",
    "RotationError",
    "RotationSpline",
    "Screw",
    "Slerp",
    "Squad",
    "T_q",
    "ZeroRotationError",
    "align",
    "align_points",
    "change_of_axes",
    "convert_points",
    "convert_rotation",
    "integrate",
    "inverse_left_jacobian",
    "left_jacobian",
    "reflect2",
    "reflection",
    "rotate",
    "rotate2",
    "rotate_euler",
    "rotate_quat",
    "sclerp",
    "slerp",
    "squad",
    "swing_twist",
    "threads",
    "warm_up",
]


def __getattr__(name: str) -> Any:
    if name not in _HOME_OF:
        raise AttributeError(f"module 'rotation' has no attribute {name!r}")
    value = getattr(import_module(f"rotation.{_HOME_OF[name]}"), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
