"""Former names of modules of :mod:`hfield.fields`, which was ``hfield.rings`` in version 0.3.

The names in ``hfield.rings`` still work for one version, with a warning. Pickles of version 0.3 refer to its
modules, and load without a warning.
"""

import sys
import warnings
from importlib import import_module
from types import ModuleType

from hfield.lazy_alias import lazy_alias

MOVED = {
    "base": "base.ring",
    "coefficients": "base.coefficients",
    "operators": "base.operators",
    "printing": "base.printing",
    "rational": "base.coercion",
    "closed_fields": "algebraic",
    "closed_fields.algebraic": "algebraic.ring",
    "closed_fields.closed_forms": "algebraic.closed_forms",
    "closed_fields.in_fields": "algebraic.in_fields",
    "closed_fields.surds": "algebraic.surds",
    "finite": "finite.ring",
    "floats": "floats",
    "integers": "rationals.ring",
    "polynomials": "polynomial_rings",
}


def _former_module(name: str, target: str) -> ModuleType:
    """Return a module whose attributes are those of its successor, which is imported on first use."""
    module = ModuleType(f"{__name__}.{name}", f"Former name of :mod:`hfield.fields.{target}`.")
    get, names = lazy_alias(f"hfield.fields.{target}")
    vars(module).update(__getattr__=get, __dir__=names, __path__=[])
    return module


for _name, _target in MOVED.items():
    sys.modules[f"{__name__}.{_name}"] = _former_module(_name, _target)


def __getattr__(name: str) -> object:
    """Return a name of hfield.fields with a warning; ``ring`` is a name of hfield itself."""
    if name.startswith("__"):  # attributes that the import system reads from every module
        raise AttributeError(name)
    if name in MOVED:
        return sys.modules[f"{__name__}.{name}"]
    place, present = {"ring": ("hfield", "ring"), "Known": ("hfield.fields", "Fact")}.get(
        name, ("hfield.fields", name)
    )
    found = getattr(import_module(place), present)
    warnings.warn(
        f"hfield.rings.{name} is now {place}.{present}; the next version drops the old name",
        DeprecationWarning,
        stacklevel=2,
    )
    return found
