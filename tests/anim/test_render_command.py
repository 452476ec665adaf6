"""``hfield render`` as a user types it."""

import json
import os
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from anim.output import FORMATS
from anim.picture import STYLES
from hfield.cli import main
from tests.subcases import pairs_quick

SHORT = ("--points", "30", "--frames", "6")
SMALL = ("--size", "96x72", *SHORT)


def run(capsys, *words):
    status = main(("render", *map(str, words)))
    out, err = capsys.readouterr()
    assert "Traceback" not in err
    return status, out, err


@pytest.mark.slow
@pytest.mark.parametrize("name", [*(f"t.{name}" for name in FORMATS), "t.html", "T.MP4", "t"])
def test_every_suffix(capsys, tmp_path: Path, name: str) -> None:
    words = SHORT if name.endswith(".html") else SMALL  # a page has no size
    status, out, _ = run(capsys, *words, "-o", tmp_path / name)
    assert status == 0
    assert out.startswith(f"{tmp_path / name}: 6 frames")
    assert os.listdir(tmp_path) == [name]


@pytest.mark.parametrize(
    ("model", "style"),
    pairs_quick(["quaternions", "product", "euler", "matrix", "physics", "free"], STYLES, 3),
)
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
    status, out, _ = run(capsys, "--sheet", "--points", "30", "--size", "60x45", "-o", path)
    assert status == 0
    assert "sheet.png: 10 frames of 500: 0, 49, 99, 149" in out
    with Image.open(path) as image:
        assert image.size == (5 * 66 + 6, 2 * 51 + 6)
    status, _, err = run(capsys, "--sheet", "-o", tmp_path / "sheet.mp4")
    assert status == 2
    assert "expected a name such as sheet.png" in err


@pytest.mark.slow
def test_preview_is_small_and_quick(capsys, tmp_path: Path) -> None:
    words = ("--preview", "--points", "30", "-o", tmp_path / "t.mp4", "--format", "json")
    status, out, _ = run(capsys, *words)
    assert status == 0
    made = json.loads(out)
    assert (made["frames"], made["fps"], made["duration"], made["size"]) == (
        500,
        50.0,
        10.0,
        [320, 240],
    )


@pytest.mark.slow
def test_a_preview_has_fewer_bytes_than_the_film(capsys, tmp_path: Path) -> None:
    film, preview = tmp_path / "film.mp4", tmp_path / "preview.mp4"
    words = ("--points", "30", "--frames", "25")
    assert run(capsys, *words, "-o", film)[0] == run(capsys, *words, "--preview", "-o", preview)[0]
    assert preview.stat().st_size < 0.8 * film.stat().st_size


@pytest.mark.slow
def test_a_size_that_is_given_wins_over_the_preview(capsys, tmp_path: Path) -> None:
    words = ("--preview", *SMALL, "-o", tmp_path / "t.gif", "--format", "json")
    status, out, _ = run(capsys, *words)
    assert status == 0
    assert json.loads(out)["size"] == [96, 72]


def picture(capsys, path: Path, *words):
    status, out, err = run(capsys, *SMALL, *words, "--force", "-o", path)
    assert (status, err) == (0, "")
    return out, np.asarray(Image.open(path))


def test_one_frame_of_the_film(capsys, tmp_path: Path) -> None:
    assert run(capsys, *SMALL, "-o", tmp_path / "film")[0] == 0
    out, fourth = picture(capsys, tmp_path / "x.png", "--frame", "4")
    assert "x.png: frame 4 of 6, 0.08 s into the film" in out
    np.testing.assert_array_equal(fourth, np.asarray(Image.open(tmp_path / "film/frame_00004.png")))
    out, only = picture(capsys, tmp_path / "x.png", "--frames", "1")
    assert "frame 0 of 1" in out
    assert only.shape == fourth.shape


def test_without_options_the_film_is_shaded_with_trace_and_shadow(capsys, tmp_path: Path) -> None:
    path = tmp_path / "x.png"
    (_, plain), (_, full) = (
        picture(capsys, path, "--frame", "4", *words)
        for words in ((), ("--style", "shaded", "--trace", "--shadow"))
    )
    np.testing.assert_array_equal(plain, full)
    others = [("--style", "flat"), ("--no-trace",), ("--no-shadow",)]
    for words in others:
        _, other = picture(capsys, path, "--frame", "4", *words)
        assert (other != plain).any()


def test_the_page_shows_four_models_or_one(capsys, tmp_path: Path) -> None:
    for words, count, curves in (
        ((), 4, 0),
        (("--model", "euler"), 1, 0),
        (("--model", "physics"), 1, 2),
    ):
        path = tmp_path / f"t{len(words)}{curves}.html"
        assert run(capsys, *SHORT, *words, "--background", "navy", "-o", path)[0] == 0
        text = path.read_text(encoding="utf-8")
        data = json.loads(text.partition('id="data">')[2].partition("</script>")[0])
        assert (len(data["shows"]), len(data["curves"])) == (count, curves)
        assert "--paper: #000080" in text


def test_misleading_bands_are_reported(capsys, tmp_path: Path) -> None:
    words = ("--size", "32x24", "--points", "30", "--frames", "100", "--spin", "accumulated")
    status, _, err = run(capsys, *words, "-o", tmp_path / "t")
    assert status == 0
    assert "note: the bands seem to" in err


def test_a_seed_turns_the_top_to_another_side(capsys, tmp_path: Path) -> None:
    pages = []
    words = ("--seed", "3", "-o", tmp_path / "t.html")  # for the others there is nothing to choose
    assert run(capsys, *SHORT, *words)[0] == 0
    for seed in ("1", "1", "2"):
        path = tmp_path / f"{len(pages)}.html"
        assert run(capsys, *SHORT, "--model", "physics", "--seed", seed, "-o", path)[0] == 0
        pages.append(path.read_text(encoding="utf-8"))
    assert pages[0] == pages[1] != pages[2]


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (("-o", "t.avi"), f"expected .{next(iter(FORMATS))}"),
        (("-o", "t.mp4", "--frames", "0"), "frames is 0"),
        (("-o", "t.png", "--frame", "500"), "expected a number from 0 to 499"),
        (("-o", "t.png", "--frame", "-1"), "--frame is -1"),
        (("-o", "t.mp4", "--frame", "1"), "expected a name such as frame.png"),
        (("-o", "t.jpg"), "the format '.jpg' is unknown"),
        (("-o", "t.mp4", "--frames", "-5"), "frames is -5"),
        (("-o", "t.mp4", "--size", "101x100"), "try --size 102x100"),
        (("-o", "t.mp4", "--size", "0x0"), "the width is 0"),
        (("-o", "t.mp4", "--size", "999999x999999"), "the width is 999999"),
        (("-o", "t.mp4", "--size", "big"), "expected WIDTHxHEIGHT such as 640x480"),
        (("-o", "t.mp4", "--points", "2"), "expected a number from 3"),
        (("-o", "t.mp4", "--bands", "0"), "bands is 0"),
        (("-o", "t.mp4", "--p2", "wide"), "expected one of printed, third"),
        (("-o", "t.mp4", "--style", "fancy"), f"expected one of {', '.join(STYLES)}"),
        (("-o", "t.mp4", "--camera", "up"), "camera"),
        (("-o", "t.mp4", "--background", "grue"), "expected a colour"),
        (("-o", "t.mp4", "--spin", "fast"), "expected one of absolute, accumulated"),
        (("-o", "t.mp4", "--angle", "nan"), "finite"),
        (("-o", "t.mp4", "--motion-blur", "2"), "from 0 to 1"),
        (("-o", "t.mp4", "--crf", "99"), "crf is 99"),
        (("-o", "t.gif", "--crf", "20"), "--crf belongs to .mp4 and .webp, not to t.gif"),
        (("-o", "t.html", "--crf", "20"), "--crf belongs to .mp4 and .webp"),
        (("-o", "t.webp", "--preset", "fast"), "--preset belongs to .mp4"),
        (("-o", "t.mp4", "--tilt", "89"), "tilt is 89°"),
        (("-o", "t.mp4", "--quality", "9"), "quality is 9"),
        (("-o", "t.mp4", "--friction", "1e9"), "at most 5"),
        (("-o", "t.mp4", "--gravity", "1e300"), "choose less spin"),
        (("-o", "t.mp4", "--precession", "1e200"), "choose less spin"),
        (("-o", "t.mp4", "--spin-decay", "1e-300"), "choose less spin"),
        (("-o", "t.mp4", "--tip-radius", "1e9"), "out of all proportion"),
        (("-o", "t.mp4", "--rolling", "1e9"), "out of all proportion"),
        (
            ("-o", "t.mp4", "--model", "product", "--mass", "1"),
            "--mass belongs to --model free or physics",
        ),
        (("-o", "t.mp4", "--model", "physics", "--mass", "-1"), "mass is -1"),
        (("-o", "t.mp4", "--model", "physics", "--tilt", "80"), "the rim is on the ground"),
        (("-o", "t.mp4", "--model", "physik"), "physics"),
        (("-o", "no/such/folder/t.mp4"), "does not exist"),
        (("--frames", "5"), "-o"),
        (("-o", "t", "--frames", "3", "--duration", "1e-300"), "fps is 3e+300"),
        (("-o", "-"), "needs an output file"),
        (("-o", "t.mp4", "--background", "none"), "transparent"),
        (("-o", "t.gif", "--duration", "1e9", "--frames", "3"), "too few for .gif"),
        (("-o", "t.mp4", "--model", "physics", "--mass", "1e300"), "choose another mass"),
        (("-o", "t.mp4", "--model", "physics", "--scale", "1e-60"), "choose another mass"),
        (("-o", "t.mp4", "--model", "physics", "--scale", "1e200"), "choose another mass"),
        (("-o", ""), "needs an output file"),
        (("-o", "t.html", "--points", "20000"), "at most 10000 points a ring"),
        (("-o", "t.html", "--frames", "200000"), "at most 100000 frames"),
        (("-o", "t", "--points", "100000", "--bands", "20000"), "bands is 20000"),
        (("-o", "t.png", "--sheet", "--figures"), "not allowed with"),
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


def test_what_cannot_be_written_is_refused_before_the_motion_is_computed(
    capsys, tmp_path, monkeypatch
) -> None:
    monkeypatch.setattr("anim.pipelines.kinematic", lambda *_: pytest.fail("computed"))
    (tmp_path / "there.html").touch()
    for words in (("x.avi",), ("x.mp4", "--size", "3x3"), ("there.html",), ("x.jpg", "--sheet")):
        path, *more = words
        assert run(capsys, "--frames", 90_000, "-o", tmp_path / path, *more)[0] == 2


@pytest.mark.slow
def test_the_figures_of_section_3(capsys, tmp_path: Path) -> None:
    status, out, _ = run(capsys, "--figures", "-o", tmp_path / "new")
    assert status == 0
    paths = [Path(line) for line in out.splitlines()]
    assert sorted(paths) == sorted((tmp_path / "new").iterdir())
    assert [path.name for path in paths][:2] == ["points.png", "skeleton.png"]
    before = paths[0].read_bytes()
    status, _, err = run(capsys, "--figures", "-o", tmp_path / "new")
    assert status == 2
    assert "points.png' exists; --force replaces it" in err
    paths[0].write_bytes(b"")
    status, out, _ = run(capsys, "--figures", "--force", "--format", "json", "-o", tmp_path / "new")
    assert status == 0
    assert json.loads(out)["files"] == [str(path) for path in paths]
    assert paths[0].read_bytes() == before


@pytest.mark.slow
def test_a_home_that_cannot_be_written_is_not_worth_a_word(tmp_path: Path) -> None:
    places = {"HOME": "/dev/null", "TMPDIR": str(tmp_path), "PATH": os.environ["PATH"]}
    words = [sys.executable, "-m", "hfield", "render", *SMALL, "--jobs", "2", "--bands", "1"]
    words += ["--style", "classic", "--duration", "0.1", "-o", str(tmp_path / "t")]
    done = subprocess.run(words, capture_output=True, text=True, check=False, env=places)
    assert (done.returncode, len(os.listdir(tmp_path / "t"))) == (0, 6)
    assert "atplotlib" not in done.stderr


@pytest.mark.slow
def test_the_time_left_is_reported_on_a_terminal(tmp_path: Path) -> None:
    import pty

    ours, theirs = pty.openpty()
    words = [sys.executable, "-m", "hfield", "render", "--size", "64x48", "--points", "30"]
    words += ["--frames", "1500", "-o", str(tmp_path / "t.apng")]
    running = subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=theirs)
    os.close(theirs)
    said = b""
    while True:
        try:
            part = os.read(ours, 4096)
        except OSError:  # so a terminal tells that nobody writes any more
            break
        if not part:
            break
        said += part
    os.close(ours)
    assert running.wait() == 0
    assert re.search(rb"\[#* *\] \d+ of 1500 frames, \d+ s left", said)
    assert said.endswith(b"\r\x1b[K")


def test_seeing_quaternions_is_a_page_of_its_own(capsys, tmp_path: Path) -> None:
    path = tmp_path / "s3.html"
    assert run(capsys, "--quaternions", "-o", path)[0] == 0
    assert "600-cell" in path.read_text(encoding="utf-8")
    status, _, err = run(capsys, "--quaternions", "-o", path)
    assert status == 2
    assert "--force" in err
    status, _, err = run(capsys, "--quaternions", "-o", tmp_path / "s3.mp4")
    assert status == 2
    assert "expected a name such as s3.html" in err


def test_the_default_film_tells_how_a_top_falls(capsys, tmp_path: Path) -> None:
    words = (*SMALL, "-o", tmp_path / "t", "--format", "json", "--force")
    made = json.loads(run(capsys, *words)[1])
    assert (made["model"], made["duration"]) == ("free", 0.12)
    assert 5 < made["landed"] < 8
    made = json.loads(run(capsys, *words, "--spin-rate", "0", "--tip-radius", "0.05")[1])
    assert (made["model"], made["landed"] < 2) == ("free", True)
    assert json.loads(run(capsys, *words, "--order", "tilt-first")[1])["model"] == "quaternions"
    status, _, err = run(capsys, *words, "--model", "physics", "--friction", "0.1")
    assert (status, "--friction belongs to --model free" in err) == (2, True)


def test_dark_paper(capsys, tmp_path: Path) -> None:
    words = ("--frame", "3", "--size", "64x48", "--dark")
    assert picture(capsys, tmp_path / "x.png", *words)[1][0, 0].tolist() == [0x17, 0x18, 0x1B]
    white = picture(capsys, tmp_path / "x.png", *words, "--background", "white")[1]
    assert white[0, 0].tolist() == [255] * 3


def test_captions_on_request(capsys, tmp_path: Path) -> None:
    path = tmp_path / "x.png"
    words = ("--frame", "3", "--model", "product", "--size", "320x240")
    plain, english, polish = (
        picture(capsys, path, *words, *more)[1].astype(int)
        for more in ((), ("--captions",), ("--captions", "pl"))
    )
    for captioned in (english, polish):
        assert captioned.shape == plain.shape
        assert (captioned != plain).any()
    assert (english != polish).any()
