"""`rotation` and `anim` answer to `hfield.rotation` and `hfield.anim` too, and cost nothing until used."""

import pickle
import subprocess
import sys
from importlib import import_module

import pytest

from hfield.former_names.rings import MOVED
from tests.patience import PATIENCE


@pytest.mark.parametrize("package", ["rotation", "anim"])
def test_the_same_things_by_the_second_name(package: str) -> None:
    real, second = import_module(package), import_module(f"hfield.{package}")
    assert dir(second) == dir(real)
    assert all(getattr(second, name) is getattr(real, name) for name in dir(real))
    with pytest.raises(AttributeError, match="nonsense"):
        _ = second.nonsense
    with pytest.raises(ModuleNotFoundError, match="is not a package"):
        import_module(f"hfield.{package}.errors")  # no second copy of what is inside


def test_nothing_is_imported_before_it_is_used() -> None:
    code = (
        "import sys, hfield, hfield.rotation, hfield.anim\n"
        "assert not {'rotation', 'anim', 'numpy'} & set(sys.modules)\n"
        "from hfield.rotation import Rotation\n"
        "from hfield.anim import Top\n"
        "assert (Rotation.__module__, Top.__module__) == ('rotation.rotation', 'anim.top')\n"
    )
    subprocess.run([sys.executable, "-c", code], check=True, timeout=PATIENCE)


@pytest.mark.parametrize(
    ("module", "former", "name"),
    [
        ("hfield.rings", "ring", "hfield.ring"),
        ("hfield.rings", "Known", "hfield.fields.Fact"),
        ("hfield.rings", "Ring", "hfield.fields.Ring"),
        ("anim", "Look", "anim.RenderSettings"),
    ],
)
def test_former_names_work_with_a_warning(module: str, former: str, name: str) -> None:
    package, _, present = name.rpartition(".")
    with pytest.warns(DeprecationWarning, match=f"is now {name}"):
        found = getattr(import_module(module), former)
    assert found is getattr(import_module(package), present)


def test_modules_that_pickles_of_version_03_name_are_there() -> None:
    for path, name, present in (
        ("hfield.rings.integers", "QQ", "hfield.fields.rationals.ring"),
        ("hfield.rings.finite", "ExtensionField", "hfield.fields.finite.ring"),
        ("hfield.rings.base", "_shared", "hfield.fields.base.ring"),
        ("hfield.rings.closed_fields.surds", "Surd", "hfield.fields.algebraic.surds"),
    ):
        found = pickle.loads(f"c{path}\n{name}\n.".encode())
        assert found is getattr(import_module(present), name)


def test_former_modules_of_rings_lead_somewhere() -> None:
    for name, target in MOVED.items():
        former = import_module(f"hfield.rings.{name}")
        assert dir(former) == dir(import_module(f"hfield.fields.{target}"))
