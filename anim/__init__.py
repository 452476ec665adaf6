"""The spinning top: its shape, its motion, and its pictures.

>>> from anim import Model, kinematic
>>> Model().counts()["polygons"], kinematic().frames
(3000, 500)
"""

import lazy_loader

import hfield.core.locks  # noqa: F401  # a fork may come while the names below are imported

# The public names are said once, in the stub beside this file, and imported on first use.
__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
