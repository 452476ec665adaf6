"""The package :mod:`anim` by a name that nothing else has: ``from hfield.anim import …``."""

from hfield.lazy_alias import lazy_alias

__getattr__, __dir__ = lazy_alias("anim")
