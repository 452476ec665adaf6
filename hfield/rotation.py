"""The package :mod:`rotation` under a unique name: ``from hfield.rotation import …``."""

from hfield.lazy_alias import lazy_alias

__getattr__, __dir__ = lazy_alias("rotation")
