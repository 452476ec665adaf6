"""The public names of the three packages: a name added, lost or moved is seen here."""

from importlib import import_module

import pytest

NAMES = {
    "hfield": """
        CC CoercionError GF H HFieldError Ideal Lattice MixedParentsError NotFiniteError
        NotInvertibleError NotationError Order QQ Quaternion QuaternionAlgebra RDF RR RingError
        TooLargeError UndecidedError ZZ Zmod conj conjugator errors explain four_squares
        hilbert_symbol inv norm places prove ring trace verify
    """,
    "rotation": """
        DTypeError ForeignArrayError R2 R_x R_y R_z RigidTransform Rotation RotationError
        RotationSpline Screw Slerp Squad T_q ZeroRotationError align align_points change_of_axes
        convert_points convert_rotation integrate inverse_left_jacobian left_jacobian reflect2
        reflection rotate rotate2 rotate_euler rotate_quat sclerp slerp squad swing_twist
        threads warm_up
    """,
    "anim": """
        AnimationError Body Camera Clip Launch Look Model Motion PIPELINES Timeline Top
        apparent_spin clip compare errors kinematic physical render
    """,
}


@pytest.mark.parametrize("package", NAMES)
def test_the_public_names(package: str) -> None:
    module = import_module(package)
    assert dir(module) == sorted(NAMES[package].split())
    for name in dir(module):
        value = getattr(module, name)
        assert not callable(value) or value.__doc__, f"{package}.{name} has no docstring"


@pytest.mark.parametrize("package", NAMES)
def test_no_other_name_is_handed_out(package: str) -> None:
    with pytest.raises(AttributeError, match="nonsense"):
        _ = import_module(package).nonsense
