"""Films as files, by suffix: video, moving pictures, folders of pictures. Whole or not at all."""

import lazy_loader

# The public names are said once, in the stub beside this file, and imported on first use.
__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
