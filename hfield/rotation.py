"""The package :mod:`rotation` by a name that nothing else has: ``from hfield.rotation import …``."""

from hfield.lazy_alias import lazy_alias

__getattr__, __dir__ = lazy_alias("rotation")
