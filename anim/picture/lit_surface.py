"""The background of the shaded style: lit ground, with a camera that may follow the top."""

import numpy as np
from numpy.typing import NDArray

from anim.picture.environment import darkness, environment, ground, to_ground
from anim.picture.projection import View
from anim.picture.settings import RGB, RenderSettings
from anim.picture.surface import Floats, Surface

Light = NDArray[np.float32]


class LitSurface(Surface):
    """A picture over the ground; :attr:`floor` is the ground in floats (height, width, 3), 0 to 255."""

    def __init__(self, view: View, settings: RenderSettings, paper: RGB) -> None:
        from anim.picture.ground_kernels import grained

        self.floor: Light = ground(view, settings, paper)
        background = np.empty(self.floor.shape, np.uint8)
        grained(self.floor, background)
        super().__init__(background)
        self._view, self._paper = view, paper
        self._places: Light | None = None

    def move(self, centre: Floats) -> None:
        """Show the ground as seen by a camera moved to ``centre`` (2,)."""
        from anim.picture.ground_kernels import moved_ground, seen_ground

        if self._view.eye[2] <= 0:
            return
        numbers = environment()["ground"]
        if self._places is None:
            self._places = np.empty((self.height, self.width, 5), np.float32)
            map_ = to_ground(self._view, self.height)
            seen_ground(self._places, map_, float(numbers["near"]), float(numbers["far"]))
            rows = np.flatnonzero(self._places[:, :, 2].any(axis=1))
            self._first = int(rows[0]) if len(rows) else self.height
        values = (darkness(self._paper), *(numbers[n] for n in ("shade", "pool", "ring")), *centre)
        moved_ground(
            self.floor,
            self._background,
            self._first,
            self._places,
            np.array(self._paper, np.float32),
            np.array(values, np.float32),
        )
