"""The package :mod:`anim` by a name that nothing else has: ``from hfield.anim import …``."""

from hfield.handed_on import handed_on

__getattr__, __dir__ = handed_on("anim")
