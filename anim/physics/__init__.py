"""The top that obeys physics: its inertia, its equations of motion, pinned or free, and their solution."""

from anim.physics.free import Contact, FreeTop
from anim.physics.inertia import Body
from anim.physics.launch import Launch
from anim.physics.simulate import HeavyTop, physical

__all__ = ["Body", "Contact", "FreeTop", "HeavyTop", "Launch", "physical"]
