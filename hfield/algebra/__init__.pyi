from .quaternion_algebra import H as H
from .quaternion_algebra import QuaternionAlgebra as QuaternionAlgebra
from .quaternion_algebra import ternary_form as ternary_form
