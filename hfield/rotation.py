"""The package :mod:`rotation` by a name that nothing else has: ``from hfield.rotation import …``."""

from hfield.handed_on import handed_on

__getattr__, __dir__ = handed_on("rotation")
