"""The spinning top: its shape, its motion, and its pictures.

>>> from anim import Model, kinematic
>>> Model().counts()["polygons"], kinematic().frames
(3000, 500)
"""

import warnings

import lazy_loader

import hfield.core.locks  # noqa: F401  # a fork may come while the names below are imported

# The public names are listed once, in the stub next to this file, and imported on first use.
_attribute, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)


def __getattr__(name: str) -> object:
    """Import a public name; ``Look`` is the former name of ``RenderSettings``."""
    if name == "Look":
        message = "anim.Look is now anim.RenderSettings; the next version drops the old name"
        warnings.warn(message, DeprecationWarning, stacklevel=2)
        name = "RenderSettings"
    return _attribute(name)
