"""The top that obeys physics: its inertia, its equations of motion and their solution."""

from anim.physics.inertia import Body
from anim.physics.simulate import HeavyTop, Launch, physical

__all__ = ["Body", "HeavyTop", "Launch", "physical"]
