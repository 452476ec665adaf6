"""What the shaded style draws on: ground in the light, over which a camera may follow the top."""

import numpy as np
from numpy.typing import NDArray

from anim.picture.look import RGB, Look
from anim.picture.projection import View
from anim.picture.room import ground
from anim.picture.surface import Floats, Surface

Light = NDArray[np.float32]


class LitSurface(Surface):
    """A picture over the ground; :attr:`floor` is the ground in floats (height, width, 3), 0 to 255."""

    floor: Light

    def __init__(self, view: View, look: Look, paper: RGB) -> None:
        self._view, self._look, self._paper = view, look, paper
        self._centre = np.zeros(2)
        self._pave()
        super().__init__(self._background)

    def move(self, centre: Floats) -> None:
        """Show the ground as the camera sees it that has gone to ``centre`` (2,)."""
        if not np.array_equal(centre, self._centre):
            self._centre = np.array(centre, dtype=np.float64)
            self._pave()

    def _pave(self) -> None:
        from anim.picture.ground import grained

        self.floor = ground(self._view, self._look, self._paper, self._centre)
        self._background = np.empty(self.floor.shape, np.uint8)
        grained(self.floor, self._background)
