"""Physical tops: inertia, equations of motion (with fixed tip or free), and their solution."""

from anim.physics.films import physical
from anim.physics.free_top import Contact, FreeTop
from anim.physics.heavy_top import HeavyTop
from anim.physics.inertia import Body
from anim.physics.launch import Launch

__all__ = ["Body", "Contact", "FreeTop", "HeavyTop", "Launch", "physical"]
