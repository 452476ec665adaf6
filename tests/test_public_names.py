"""The public names of the three packages: a name added, lost or moved is seen here."""

from importlib import import_module

import pytest

NAMES = {
    "hfield": """
        CC CoercionError GF H HFieldError Ideal Lattice MixedParentsError NotFiniteError
        NotInvertibleError NotationError NumberField Order QQ Quaternion QuaternionAlgebra RDF RR RingError
        TooLargeError UndecidedError ZZ Zmod conjugator errors four_squares hilbert_symbol places
        prove ring
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
