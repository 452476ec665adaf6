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

__path__.append(f"{__path__[0]}/former_names")  # whose modules pickles name without that folder

provide(REGISTRY)

# The public names are said once, in the stub beside this file, and imported on first use.
_attribute, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)


def __getattr__(name: str) -> object:
    """Import a public name; for a name of another system, say what to write instead."""
    try:
        return _attribute(name)
    except AttributeError as error:
        from hfield.hints import ForeignImportError, ForeignNameError, called_here

        if not (here := called_here(name)):
            raise
        message = f"hfield has no {name!r}: write {here}"
        # ``from hfield import name`` drops the message of an AttributeError, and ``hasattr`` needs one:
        # the importing function of Python is known by its name.
        if sys._getframe(1).f_code.co_name == "_handle_fromlist":
            raise ForeignImportError(message, name=__name__) from None
        raise ForeignNameError(message, name=name) from error
