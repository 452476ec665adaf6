"""Symbols, conics, norm forms, splittings and isomorphisms: functions of a ring and constants (a, t, b).

``docs/reference/structure.md`` lists which module decides what, and how.
"""

import lazy_loader

# The public names are listed once, in the stub beside this file, and imported on first use.
__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
