"""Properties of algebras and elements, as functions of the ring, the constants (a, t, b) and coordinates.

The classes of algebras and elements call these functions. ``docs/reference/structure.md`` lists the module
for each question.
"""

import lazy_loader

# The public names are listed once, in the stub beside this file, and imported on first use.
__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
