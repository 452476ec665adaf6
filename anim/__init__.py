"""The spinning top: its shape, its motion, and its pictures.

>>> from anim import Model, kinematic
>>> Model().counts()["polygons"], kinematic().frames
(3000, 500)
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from anim.bands import apparent_spin
    from anim.film import Clip, clip
    from anim.model import Model
    from anim.motion import Motion
    from anim.physics import Body, Launch, physical
    from anim.pipelines import PIPELINES, compare, kinematic
    from anim.timeline import Timeline
    from anim.top import Top

# Where the public names live. They are imported on first use: the face of the package costs nothing.
_HOMES = {
    "bands": ["apparent_spin"],
    "film": ["Clip", "clip"],
    "model": ["Model"],
    "motion": ["Motion"],
    "physics": ["Body", "Launch", "physical"],
    "pipelines": ["PIPELINES", "compare", "kinematic"],
    "timeline": ["Timeline"],
    "top": ["Top"],
}
_HOME_OF = {name: module for module, names in _HOMES.items() for name in names}

__all__ = [
    "PIPELINES",
    "Body",
    "Clip",
    "Launch",
    "Model",
    "Motion",
    "Timeline",
    "Top",
    "apparent_spin",
    "clip",
    "compare",
    "kinematic",
    "physical",
]


def __getattr__(name: str) -> Any:
    if name not in _HOME_OF:
        raise AttributeError(f"module 'anim' has no attribute {name!r}")
    value = getattr(import_module(f"anim.{_HOME_OF[name]}"), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
