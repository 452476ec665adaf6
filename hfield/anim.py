"""The package :mod:`anim` under a unique name: ``from hfield.anim import …``."""

from hfield.lazy_alias import lazy_alias

__getattr__, __dir__ = lazy_alias("anim")
