"""A small film: its scene, and its frames."""

import numpy as np
import pytest

from anim.film import clip
from anim.model import Model
from anim.picture import RenderSettings
from anim.pipelines import kinematic
from anim.rendering import Scene, frames
from tests.anim.films import FRAMES, SIZE


@pytest.fixture(scope="module")
def scene() -> Scene:
    look = RenderSettings(size=SIZE, trace=True, shadow=True)
    return Scene(Model(ring=60), kinematic("product", clip(frames=FRAMES, fps=25)), look)


@pytest.fixture(scope="module")
def raw(scene: Scene) -> np.ndarray:
    return np.stack(list(frames(scene)))
