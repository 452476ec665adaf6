"""Quaternion algebras over arbitrary rings: compute in them, and decide statements about them.

>>> from hfield import GF, H
>>> A = H(GF(7)); e, i, j, k = A.basis
>>> (1 + i) * (j - k)**-1
6*j
"""

import sys

import lazy_loader

import hfield.core.locks  # noqa: F401  # a fork may come while the names below are imported
from hfield.fields.base.registry import REGISTRY
from hfield.fields.provided import provide

__version__ = "0.4.0"

__path__[1:] = [f"{__path__[0]}/former_names"]  # whose modules pickles name without that folder

provide(REGISTRY)

# The public names are listed once, in the stub next to this file, and imported on first use.
_attribute, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)


def __getattr__(name: str) -> object:
    """Import a public name; for a name of another system, raise an error with the hfield name."""
    try:
        return _attribute(name)
    except AttributeError as error:
        from hfield.hints import ForeignNameError, called_here

        if not (here := called_here(name)):
            raise
        message = f"hfield has no {name!r}: write {here}"
        raise ForeignNameError(message, name=name) from error


class _ForeignImports:
    """The last finder of modules: for a name of another system it says what to write instead.

    ``from hfield import name`` looks for an attribute, whose error Python drops, and then for a module. The
    error must not have the full name of that module: Python would drop it, too.
    """

    @staticmethod
    def find_spec(fullname: str, path: object = None, target: object = None) -> None:
        package, _, name = fullname.rpartition(".")
        if package == __name__:
            from hfield.hints import ForeignImportError, called_here

            if here := called_here(name):
                message = f"hfield has no {name!r}: write {here}"
                raise ForeignImportError(message, name=name)


if all(getattr(finder, "__module__", None) != __name__ for finder in sys.meta_path):
    sys.meta_path.append(_ForeignImports)  # once, also if hfield is imported again
