"""``hfield render`` as a user types it."""

import json
import os
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from hfield.cli import main

SMALL = ("--size", "96x72", "--points", "30", "--frames", "6")


def run(capsys, *words):
    status = main(("render", *map(str, words)))
    out, err = capsys.readouterr()
    assert "Traceback" not in err
    return status, out, err


@pytest.mark.parametrize("name", ["t.mp4", "t.gif", "t.apng", "t.webp", "t.html", "T.MP4", "t"])
def test_every_suffix(capsys, tmp_path: Path, name: str) -> None:
    status, out, _ = run(capsys, *SMALL, "-o", tmp_path / name)
    assert status == 0
    assert out.startswith(f"{tmp_path / name}: 6 frames")
    assert os.listdir(tmp_path) == [name]


@pytest.mark.parametrize("model", ["quaternions", "product", "euler", "matrix", "physics"])
@pytest.mark.parametrize("style", ["flat", "classic", "shaded"])
def test_every_model_in_every_style(capsys, tmp_path: Path, model: str, style: str) -> None:
    path = tmp_path / "t"
    words = (
        *SMALL,
        "--model",
        model,
        "--style",
        style,
        "--trace",
        "--shadow",
        "-o",
        path,
        "--format",
        "json",
    )
    status, out, _ = run(capsys, *words, "--spin", "accumulated")
    assert status == 0
    made = json.loads(out)
    assert (made["schema"], made["model"], made["frames"]) == ("hfield-render/1", model, 6)
    assert made["bytes"] == sum(file.stat().st_size for file in path.iterdir())
    pictures = [np.asarray(Image.open(path / f"frame_{n:05}.png")) for n in (0, 5)]
    assert pictures[0].shape == (72, 96, 3)
    assert (pictures[0] != pictures[1]).any()


def test_the_sheet(capsys, tmp_path: Path) -> None:
    path = tmp_path / "sheet.png"
    status, _, _ = run(capsys, "--sheet", "--points", "30", "--size", "60x45", "-o", path)
    assert status == 0
    with Image.open(path) as image:
        assert image.size == (5 * 66 + 6, 2 * 51 + 6)
    status, _, err = run(capsys, "--sheet", "-o", tmp_path / "sheet.mp4")
    assert status == 2
    assert "expected a name such as sheet.png" in err


def test_preview_is_small_and_quick(capsys, tmp_path: Path) -> None:
    words = ("--preview", "--points", "30", "-o", tmp_path / "t.mp4", "--format", "json")
    status, out, _ = run(capsys, *words)
    assert status == 0
    made = json.loads(out)
    assert (made["frames"], made["fps"], made["duration"], made["size"]) == (
        125,
        12.5,
        10.0,
        [320, 240],
    )


def test_the_page_shows_four_models_or_one(capsys, tmp_path: Path) -> None:
    for words, count, curves in (
        ((), 4, 0),
        (("--model", "euler"), 1, 0),
        (("--model", "physics"), 1, 2),
    ):
        path = tmp_path / f"t{len(words)}{curves}.html"
        assert run(capsys, *SMALL, *words, "--background", "navy", "-o", path)[0] == 0
        text = path.read_text(encoding="utf-8")
        data = json.loads(text.partition('id="data">')[2].partition("</script>")[0])
        assert (len(data["shows"]), len(data["curves"])) == (count, curves)
        assert "--paper: #000080" in text


def test_misleading_bands_are_told(capsys, tmp_path: Path) -> None:
    words = ("--size", "32x24", "--points", "30", "--frames", "100", "--spin", "accumulated")
    status, _, err = run(capsys, *words, "-o", tmp_path / "t")
    assert status == 0
    assert "note: the bands seem to" in err


def test_a_seed_turns_the_top_to_another_side(capsys, tmp_path: Path) -> None:
    pages = []
    for seed in ("1", "1", "2"):
        path = tmp_path / f"{len(pages)}.html"
        assert run(capsys, *SMALL, "--model", "physics", "--seed", seed, "-o", path)[0] == 0
        pages.append(path.read_text(encoding="utf-8"))
    assert pages[0] == pages[1] != pages[2]


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (("-o", "t.avi"), "expected .mp4, .gif"),
        (("-o", "t.mp4", "--frames", "0"), "frames is 0"),
        (("-o", "t.mp4", "--frames", "-5"), "frames is -5"),
        (("-o", "t.mp4", "--size", "101x100"), "try --size 102x100"),
        (("-o", "t.mp4", "--size", "0x0"), "the width is 0"),
        (("-o", "t.mp4", "--size", "999999x999999"), "the width is 999999"),
        (("-o", "t.mp4", "--size", "big"), "expected WIDTHxHEIGHT such as 640x480"),
        (("-o", "t.mp4", "--points", "2"), "expected a number from 3"),
        (("-o", "t.mp4", "--bands", "0"), "bands is 0"),
        (("-o", "t.mp4", "--p2", "wide"), "expected one of printed, third"),
        (("-o", "t.mp4", "--style", "fancy"), "expected one of flat, classic, shaded"),
        (("-o", "t.mp4", "--camera", "up"), "camera"),
        (("-o", "t.mp4", "--background", "grue"), "expected a colour"),
        (("-o", "t.mp4", "--spin", "fast"), "expected one of absolute, accumulated"),
        (("-o", "t.mp4", "--angle", "nan"), "finite"),
        (("-o", "t.mp4", "--motion-blur", "2"), "from 0 to 1"),
        (("-o", "t.mp4", "--crf", "99"), "crf is 99"),
        (("-o", "t.mp4", "--quality", "9"), "quality is 9"),
        (("-o", "t.mp4", "--mass", "1"), "--mass belongs to --model physics"),
        (("-o", "t.mp4", "--model", "physics", "--mass", "-1"), "mass is -1"),
        (("-o", "t.mp4", "--model", "physics", "--tilt", "80"), "the rim is on the ground"),
        (("-o", "t.mp4", "--model", "physik"), "physics"),
        (("-o", "no/such/folder/t.mp4"), "does not exist"),
        (("--frames", "5"), "-o"),
        (("-o", "t.mp4", "--fps", "1e9"), "fps is 1e+09"),
    ],
)
def test_bad_input_is_one_line_before_any_work(
    capsys, tmp_path, monkeypatch, words, message
) -> None:
    monkeypatch.chdir(tmp_path)
    status, out, err = run(capsys, *words)
    assert (status, out) == (2, "")
    assert len(err.strip().splitlines()) == 1
    assert message in err
    assert os.listdir(tmp_path) == []
