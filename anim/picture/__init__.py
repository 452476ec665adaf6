"""Pictures of the top: a camera, three styles, the apex's path and the shadow on the ground.

>>> from anim.model import Model
>>> from anim.picture import RenderSettings, painter
>>> import numpy as np
>>> painter(Model(ring=100), RenderSettings(size=(64, 48))).draw(np.eye(3)).shape
(48, 64, 3)
"""

import lazy_loader

# The public names are listed once, in the stub next to this file, and imported on first use.
__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
