"""Error messages for wrong arguments, with the code to write instead, also for names of other libraries.

scipy, `rotation.compat` and this package each have a class Rotation, so error messages name the package.
Classes are recognised by name, without importing them.
"""

from collections.abc import Mapping
from typing import NamedTuple

from hfield.errors import shorten
from rotation.errors import ArgumentError

OURS, COMPAT = "rotation", "rotation.compat"
NAMES = ("Rotation", "RigidTransform")  # where both meet, the second is wanted
_HOMES = ("scipy.spatial.transform", COMPAT, OURS)  # the last holds the one before


class ClassReference(NamedTuple):
    """A class of rotations or rigid transforms: its package and its name."""

    home: str
    name: str


CALLS = {
    "Kabsch, Wahba, Procrustes, Horn, QUEST": "Rotation.align_vectors(target, source)",
    "Umeyama, special_procrustes with a scale": "align_similarity(target, source)",
    "as_float_array": "r.as_quat()",
    "rotate_vectors, qvqconj": "r.apply(points)",
    "from_rotation_matrix, mat2quat, rotmat_to_unitquat": "Rotation.from_matrix(m)",
    "as_rotation_matrix, quat2mat, unitquat_to_rotmat": "r.as_matrix()",
    "from_euler_angles, euler2quat, quaternion_from_euler": 'Rotation.from_euler("xyz", angles)',
    "quat2euler, euler_from_quaternion, euler2mat": 'r.as_euler("xyz")',
    "axangle2quat, angle_axis, Rodrigues": "Rotation.from_rotvec(v)",
    "expmap, rotvec_to_rotmat": "Rotation.from_rotvec(v)",
    "logmap, rotmat_to_rotvec": "r.as_rotvec()",
    "rotation_distance, geodesic distance": "(r.inv() * s).magnitude()",
}
"""Functions of numpy-quaternion, transforms3d, roma, ROS and OpenCV; names of best fits."""


def kind(value: object) -> ClassReference | None:
    """Return the class of rotations or transforms to which a value belongs, or None."""
    for ancestor in type(value).__mro__:
        if ancestor.__name__ in NAMES:
            for home in _HOMES:
                if f"{ancestor.__module__}.".startswith(f"{home}."):
                    return ClassReference(home, ancestor.__name__)
    return None


def is_scipys(value: object, name: str) -> bool:
    """Return whether a value is scipy's class of that name, or its replacement in `rotation.compat`."""
    found = kind(value)
    return found is not None and found.home != OURS and found.name == name


def described(value: object) -> str:
    """Describe a value, or the first entry of a list, with the package of its class if the name is
    ambiguous.
    """
    inside = _first(value)
    found = kind(inside)
    of = "" if inside is value or not found else f"{type(value).__name__} of "
    return f"a {of}{'.'.join(found)}" if found else f"a {type(value).__name__}"


def _first(value: object) -> object:
    return value[0] if isinstance(value, list | tuple) and value else value


def refusal(value: object, name: str, wanted: str) -> str:
    """Return an error message: the actual type of the argument ``name``, the expected one, and what to write.

    ``wanted`` is "Rotation" or "RigidTransform", meaning the class of this package.

    Examples
    --------
    >>> from rotation.compat import Rotation
    >>> refusal(Rotation.identity(), "q", "Rotation")
    'q is a rotation.compat.Rotation; expected a rotation.Rotation: write Rotation.from_scipy(q)'
    """
    joined = _first(value) is not value and kind(_first(value)) == (OURS, wanted)
    found = kind(value)
    whose = "rotation." if found and found.name == wanted else ""
    usual_name = "t" if found and found.name == "RigidTransform" else "r"
    code = name if name.isidentifier() else usual_name
    if joined:
        way = f"{wanted}.concatenate({code})"
    else:
        way = _conversion(found, code, wanted) if found else _constructor(value, code, wanted)
    usual = "from_quat" if wanted == "Rotation" else "from_components"
    advice = f": write {way}" if way else f", such as {usual} makes"
    return f"{name} is {described(value)}; expected a {whose}{wanted}{advice}"


def refuse_arguments(call: str, others: Mapping[str, object]) -> None:
    """Raise `ArgumentError`, with a hint, for unknown arguments."""
    for name, value in others.items():
        given = shorten(repr(value))
        advice = ARGUMENTS.get(name, "").format(given)
        raise ArgumentError(f"{call} has no argument {name}{advice and f': {advice}'}")


def numbers_expected(value: object, name: str) -> str | None:
    """Return the error text for a rotation or transform passed instead of an array."""
    found = kind(_first(value))
    if found is None:
        return None
    advice = ""
    if found.name == "Rotation" and name in ("q", "quaternions"):
        advice = ": write r.as_quat(scalar_first=True)"
    elif name == "matrices":
        advice = ": write r.as_matrix()"
    elif name == "points":
        advice = ": write p * q to apply q, then p"
    return f"{name} is {described(value)}; expected an array of numbers{advice}"


def _conversion(found: ClassReference, code: str, wanted: str) -> str:
    """Return the call that converts another library's rotation or transform."""
    foreign = found.home != OURS
    if wanted == "RigidTransform":
        if found.name == wanted:
            return f"RigidTransform.from_matrix({code}.as_matrix())"
        turn = f"Rotation.from_scipy({code})" if foreign else code
        return f"RigidTransform.from_rotation({turn})"
    turn = code if found.name == wanted else f"{code}.rotation"
    return f"Rotation.from_scipy({turn})" if foreign else turn


def _constructor(value: object, code: str, wanted: str) -> str:
    """Return the constructor that fits the shape of an array; nothing if none fits."""
    shape = tuple(getattr(value, "shape", ()))
    ways = {
        "Rotation": {(4,): "from_quat", (3, 3): "from_matrix", (3,): "from_rotvec"},
        "RigidTransform": {(4, 4): "from_matrix", (6,): "from_exp_coords", (8,): "from_dual_quat"},
    }
    for last, way in ways[wanted].items():
        if shape[-len(last) :] == last:
            return f"{wanted}.{way}({code})"
    return ""


ARGUMENTS = {
    "random_state": "write seed={}",
    "num": "write shape={}",
    "vectors": "write points",
    "assume_valid": "leave it out; what is not orthogonal is an error, or orthonormalize=True",
    "suppress_warnings": "leave it out; gimbal lock gives no warning",
}
"""Arguments of scipy's."""

ROTATION = {
    "w": "as_quat()[..., 0]",
    "x": "as_quat()[..., 1]",
    "y": "as_quat()[..., 2]",
    "z": "as_quat()[..., 3]",
    "real": "as_quat()[..., 0]",
    "scalar": "as_quat()[..., 0]",
    "imag": "as_quat()[..., 1:]",
    "vec": "as_quat()[..., 1:]",
    "vector": "as_quat()[..., 1:]",
    "components": "as_quat()",
    "ndarray": "as_quat()",
    "angle": "magnitude()",
    "axis": "as_axis_angle()[0]",
    "conj": "inv()",
    "conjugate": "inv()",
    "conjugated": "inv()",
    "inverted": "inv()",
    "reciprocal": "inv()",
    "T": "inv()",
    "rotate": "apply(points), or apply_outer(points) for all pairs",
    "slerp": "slerp(p, q, t), a function of rotation",
    "rotation_matrix": "as_matrix()",
    "to_matrix": "as_matrix()",
    "to_rotation_matrix": "as_matrix()",
    "to_rotation_vector": "as_rotvec()",
    "to_axis_angle": "as_axis_angle(), or as_rotvec() for one vector",
    "to_euler": "as_euler(seq)",
    "to_euler_angles": 'as_euler("ZYZ")',
    "as_dcm": "as_matrix()",
    "from_dcm": "from_matrix(m)",
    "from_rotation_matrix": "from_matrix(m)",
    "from_rotation_vector": "from_rotvec(v)",
    "from_euler_angles": 'from_euler("ZYZ", angles)',
    "match_vectors": "align_vectors(a, b)",
}
"""quaternionic, numpy-quaternion, pyquaternion, mathutils, older scipy."""

TRANSFORM = {
    "R": "rotation.as_matrix()",
    "t": "translation",
    "matrix": "as_matrix()",
    "T": "as_matrix()",
    "transform": "apply(points)",
    "inverted": "inv()",
}
"""spatialmath, open3d, mathutils."""
