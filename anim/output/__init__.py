"""Write films to files, by suffix: video, animated pictures, folders of pictures; completely or not
at all.
"""

import lazy_loader

# The public names are listed once, in the stub next to this file, and imported on first use.
__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
