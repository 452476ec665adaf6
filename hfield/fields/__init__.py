"""Base rings and fields: the protocol :class:`Ring` that they satisfy, and a folder for each kind of ring.

Elements are raw values of the library behind the ring (see ``docs/reference/rings.md``). Names are imported
on first use, and a ring imports sympy, galois or numpy when it first needs them.
"""

import lazy_loader

# The public names are listed once, in the stub beside this file, and imported on first use.
__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
