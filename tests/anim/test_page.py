"""What the page holds, before any browser sees it."""

import base64
import json
import re

import numpy as np
import pytest

from anim.errors import AnimationError
from anim.model import Model
from anim.picture.environment import environment, trace_of
from anim.viewer import Curve, Show, page
from tests.anim.test_viewer import FRAMES, MODEL, SPIN, about


def data_of(text: str) -> dict:
    found = re.search(r'<script type="application/json" id="data">(.*?)</script>', text, re.DOTALL)
    assert found
    return json.loads(found[1])


def test_the_page_holds_the_motion_and_nothing_from_elsewhere() -> None:
    text = page(MODEL, [Show("spin", SPIN)], 50, curves=[Curve("tilt", np.arange(FRAMES), "°")])
    data = data_of(text)
    packed = np.frombuffer(base64.b64decode(data["shows"][0]["quaternions"]), "<f4")
    np.testing.assert_allclose(packed.reshape(-1, 4), SPIN, atol=1e-7)
    assert data["model"]["profile"] == [list(corner) for corner in MODEL.profile]
    assert data["model"]["sectors"] == "".join(str(b % 2) for b in MODEL.sectors)
    assert "{{" not in text
    assert not re.findall(r"https?://|src=|@import|url\(", text)
    assert "default-src 'none'" in text


def test_page_and_pictures_have_one_environment() -> None:
    text = page(MODEL, [Show("spin", SPIN)], 50)
    assert data_of(text)["environment"] == environment()
    assert f"--paper: {environment()['paper']['dark']}" in text
    assert environment()["trace"]["light"] == "#{:02x}{:02x}{:02x}".format(
        *trace_of((255, 255, 255))
    )


def test_500_frames_make_a_small_page() -> None:
    attitudes = about((0, 0, 1), np.linspace(0, 100, 500))
    assert len(page(Model(), [Show("a", attitudes)], 50).encode()) < 52_000


def test_labels_cannot_break_out_of_the_page() -> None:
    evil = "</script><script>alert(1)</script>{{title}}"
    text = page(MODEL, [Show(evil, SPIN)], 50, title=evil)
    assert "<script>alert" not in text
    assert data_of(text)["shows"][0]["label"] == evil


@pytest.mark.parametrize(
    ("shows", "message"),
    [
        ([], "at least one top"),
        ([Show("a", np.zeros((3, 3)))], r"shape \(3, 3\) does not fit"),
        ([Show("a", np.zeros((0, 4)))], "at least one frame"),
        ([Show("a", np.full((2, 4), np.nan))], "not finite"),
        ([Show("a", np.full((2, 4), 1e300))], "1e38 and more"),
    ],
)
def test_bad_motions_are_refused(shows: list[Show], message: str) -> None:
    with pytest.raises(AnimationError, match=message):
        page(MODEL, shows, 50)
