"""Quaternion algebras, their elements (one or an array), and maps between algebras."""

import lazy_loader

# The public names are listed once, in the stub beside this file, and imported on first use.
__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
