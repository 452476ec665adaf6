"""Pictures of the top: a camera, three styles, the apex's trace and the shadow on the ground.

>>> from anim.model import Model
>>> from anim.picture import Look, painter
>>> import numpy as np
>>> painter(Model(ring=100), Look(size=(64, 48))).draw(np.eye(3)).shape
(48, 64, 3)
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from anim.picture.look import STYLES, Camera, Look
    from anim.picture.painting import Painter, painter
    from anim.picture.thesis import figures

_HOME_OF = {
    "STYLES": "look",
    "Camera": "look",
    "Look": "look",
    "Painter": "painting",
    "figures": "thesis",
    "painter": "painting",
}

__all__ = ["STYLES", "Camera", "Look", "Painter", "figures", "painter"]


def __getattr__(name: str) -> Any:
    if name not in _HOME_OF:
        raise AttributeError(f"module 'anim.picture' has no attribute {name!r}")
    value = getattr(import_module(f"anim.picture.{_HOME_OF[name]}"), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
