"""What an algebra is: functions of a ring, of its constants (a, t, b) and of coordinates.

Nothing here knows the classes of algebras and elements, which hand over to these functions. The names
below are what others use; ``docs/reference/structure.md`` says which module decides what, and how.
"""

import lazy_loader

# The public names are said once, in the stub beside this file, and imported on first use.
__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
