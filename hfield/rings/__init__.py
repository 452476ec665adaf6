"""Base rings: the protocol that they satisfy, :class:`Ring`, and those that have no theory of places.

Elements are raw values of the library behind the ring (see ``docs/reference/rings.md``). Names are imported
on first use, and a ring imports sympy, galois or numpy when it first needs them.
"""

import sys
import warnings

import lazy_loader

# The names are said once, in the stub beside this file, and imported on first use.
_attribute, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)


def __getattr__(name: str) -> object:
    """Import a public name; former names work with a warning."""
    if name == "ring":
        _warn("hfield.rings.ring is now hfield.ring")
        return sys.modules["hfield"].ring
    if name == "Known":
        _warn("hfield.rings.Known is now hfield.rings.Fact")
        name = "Fact"
    return _attribute(name)


def _warn(change: str) -> None:
    warnings.warn(
        f"{change}; the next version drops the old name", DeprecationWarning, stacklevel=3
    )
