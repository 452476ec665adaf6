"""The public names of the three packages: a name added, lost or moved is seen here."""

import json
import re
from collections.abc import Iterator
from functools import cached_property
from importlib import import_module
from pathlib import Path
from types import FunctionType, ModuleType

import pytest

from hfield.fields.base.ring import Ring

NAMES = {
    "hfield": """
        CC CDF ClassSet CoercionError Description GF H HFieldError Ideal IndefiniteError Lattice LatticeError
        LedgerError MixedParentsError Newform NoEquivalentIdealError NoSolutionError NotFiniteError
        NotInvertibleError NotationError NumberField Order QQ Quaternion QuaternionAlgebra RDF RR Rejected
        Ring RingError SelectionError StructureAlgebra TableError TooLargeError UndecidedError
        UnfactoredError UnknownClaimError ZZ Zmod
        check check_ring conj conjugator errors explain four_squares hilbert_symbol info inv norm places prove
        ring ternary_form to_sympy trace verify
    """,
    "rotation": """
        BSpline DTypeError ForeignArrayError LETTER_T R2 R_x R_y R_z RigidTransform Rotation RotationError
        RotationSpline Screw Similarity Slerp Squad T_q Uncertain ZeroRotationError ad align align_points
        align_similarity angular_velocity benchmark change_of_axes convert_points convert_rotation
        compat convert_transform draw_plane exact_group exact_matrix from_exact hat integrate
        inverse_left_jacobian inverse_right_jacobian left_jacobian look_at reflect2 reflection
        right_jacobian rotate rotate2 rotate_euler rotate_quat sclerp slerp squad swing_twist threads
        vee warm_up
    """,
    "anim": """
        AnimationError Body Camera Clip Contact Film Launch Model Motion PIPELINES RenderSettings Scene
        Timeline Top apparent_spin clip compare errors kinematic motion_of physical render
    """,
}


@pytest.mark.parametrize("package", NAMES)
def test_the_public_names(package: str) -> None:
    module = import_module(package)
    assert dir(module) == sorted(NAMES[package].split())
    for name in dir(module):
        value = getattr(module, name)
        assert not callable(value) or value.__doc__, f"{package}.{name} has no docstring"


# Constants: what they are is said where they are made, and no docstring is shown for them.
NO_EXAMPLE = {"LETTER_T", "PIPELINES"}


@pytest.mark.parametrize("package", NAMES)
def test_every_public_name_has_an_example(package: str) -> None:
    module = import_module(package)
    values = {name: getattr(module, name) for name in dir(module)}
    without = {
        name
        for name, value in values.items()
        if not isinstance(value, ModuleType) and ">>> " not in (value.__doc__ or "")
    }
    assert without == NO_EXAMPLE & set(values)


@pytest.mark.parametrize("package", NAMES)
def test_no_other_name_is_handed_out(package: str) -> None:
    with pytest.raises(AttributeError, match="nonsense"):
        _ = import_module(package).nonsense


# One spelling of each thing at the surface, and what else it answers to.
ALIASES = [
    ("hfield", "QuaternionAlgebra", "center", "centre"),
    ("hfield", "Quaternion", "conjugate", "conj"),
    ("hfield", "Quaternion", "inverse", "inv"),
    ("rotation", "Rotation", "inverse", "inv"),
    ("rotation", "RigidTransform", "inverse", "inv"),
]


@pytest.mark.parametrize(("package", "kind", "name", "alias"), ALIASES)
def test_aliases(package: str, kind: str, name: str, alias: str) -> None:
    parent = getattr(import_module(package), kind)
    assert getattr(parent, alias) is getattr(parent, name)
    assert getattr(parent, name).__name__ == name


def test_methods_functions_and_language_agree() -> None:
    from hfield import QQ, H, conj, conjugator, inv, prove

    p, q = H(QQ)(1, 2, 0, 1), H(QQ)(1, 0, 2, 1)
    assert p.conj() == p.conjugate() == conj(p)
    assert p.inv() == p.inverse() == inv(p)
    x = conjugator(p, q)
    assert x is not None
    assert x == p.conjugator(q) == p.conjugacy(q).element
    assert x * p * x.inv() == q
    assert prove("norm(p) != 0 => p*inv(p) == e and conj(p) == norm(p)*inv(p)")


# A notebook or a browser opens; and a field's own methods are those of every ring, of which rings.md tells.
NOT_SHOWN = {"show", "ask", "state", "array_storage", "storage"}
_CALLED = re.compile(r"\.(\w+)")


def public_methods(package: str) -> Iterator[tuple[str, str]]:
    """Yield class and name of the methods and properties that we wrote, but those of rings."""
    module = import_module(package)
    for name in dir(module):
        kind = getattr(module, name)
        if isinstance(kind, type) and not issubclass(kind, (Exception, Ring)):
            for method in vars_of(kind):
                yield name, method


def vars_of(kind: type) -> set[str]:
    ours = [c for c in kind.__mro__ if c.__module__.split(".")[0] in NAMES]
    made = (FunctionType, classmethod, staticmethod, property, cached_property)
    return {
        name
        for parent in ours
        for name, value in vars(parent).items()
        if not name.startswith("_") and isinstance(value, made)
    }


@pytest.fixture(scope="module")
def called() -> set[str]:
    """What the examples call or read that are executed: in docstrings, pages and notebooks."""
    root = Path(__file__).parents[1]
    pages = [root / "README.md", *(root / "docs").rglob("*.md")]
    sources = [path for package in NAMES for path in (root / package).rglob("*.py")]
    found: set[str] = set()
    for path in pages + sources:
        for line in path.read_text(encoding="utf-8").splitlines():
            if line.lstrip().startswith((">>> ", "... ")):
                found.update(_CALLED.findall(line))
    for path in (root / "docs" / "notebooks").glob("*.ipynb"):
        for cell in json.loads(path.read_text(encoding="utf-8"))["cells"]:
            if cell["cell_type"] == "code":
                found.update(_CALLED.findall("".join(cell["source"])))
    return found


@pytest.mark.parametrize("package", NAMES)
def test_every_public_method_stands_in_an_example(package: str, called: set[str]) -> None:
    methods = list(public_methods(package))
    assert len(methods) > 20
    assert [m for m in methods if m[1] not in called | NOT_SHOWN] == []
