"""`hfield figures`: every figure drawn, legible, the same bytes each time, whole or not at all."""

import os
import subprocess
import sys
from itertools import combinations

import pytest

from hfield.cli import main
from hfield.cli.output import OutputError
from rotation.figures import FIGURES, Drawing, saving, turned_points
from rotation.figures.drawing import figure_style
from rotation.plane import LETTER_T
from tests.patience import PATIENCE

SIGNATURE = {"png": b"\x89PNG\r\n\x1a\n", "svg": b"<?xml", "pdf": b"%PDF"}


@pytest.fixture
def run(capsys):
    def call(*words):
        status = main(["figures", *words])
        out, err = capsys.readouterr()
        assert "Traceback" not in err
        return status, out, err

    return call


def rendered(drawing):
    """A figure after drawing, with the extents of all its texts by what they say."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    with figure_style():
        figure = Figure(figsize=drawing.size, layout="constrained")
        canvas = FigureCanvasAgg(figure)
        drawing.draw(figure)
        canvas.draw()
        renderer = canvas.get_renderer()
        texts = [
            (text.get_text(), text.get_window_extent(renderer))
            for ax in figure.axes
            for text in [*ax.texts, *(frame_texts(ax) if ax.axison else [])]
            if text.get_text().strip()
        ]
    return figure, texts


def frame_texts(ax):
    """The title, the labels of the axes and those of the ticks within their limits."""
    yield from (ax.title, ax.xaxis.label, ax.yaxis.label)
    for axis, limits in ((ax.xaxis, ax.get_xlim()), (ax.yaxis, ax.get_ylim())):
        for tick in axis.get_major_ticks():
            if limits[0] <= tick.get_loc() <= limits[1]:
                yield tick.label1


def overlaps(a, b):
    return min(a.x1, b.x1) - max(a.x0, b.x0) > 1 and min(a.y1, b.y1) - max(a.y0, b.y0) > 1


DRAWINGS = {
    **FIGURES,
    **{
        f"turned by {angle}": turned_points(LETTER_T, [angle]) for angle in (-1000, 5, 90, 150, 300)
    },
    "dots": turned_points([[1, 2], [3, -4]], [30, 60], joined=False),
}


@pytest.mark.parametrize("name", DRAWINGS)
def test_no_text_covers_another_or_leaves_the_picture(name):
    figure, texts = rendered(DRAWINGS[name])
    assert len(texts) > 5
    for text, box in texts:
        inside = (
            box.x0 >= 0 and box.y0 >= 0 and box.x1 <= figure.bbox.x1 and box.y1 <= figure.bbox.y1
        )
        assert inside, text
    covering = [(s, t) for (s, a), (t, b) in combinations(texts, 2) if overlaps(a, b)]
    assert covering == []


def test_the_test_of_texts_can_fail():
    def draw(figure):
        ax = figure.add_subplot()
        ax.text(0.5, 0.5, "one word")
        ax.text(0.52, 0.5, "another")

    _, texts = rendered(Drawing("0", "spoilt", (3, 3), draw))
    assert any(overlaps(a, b) for (_, a), (_, b) in combinations(texts, 2))


@pytest.mark.parametrize("number", ["2.3", "2.4", "2.5"])
def test_axes_are_equal(number):
    figure, _ = rendered(FIGURES[number])
    shapes = [ax for ax in figure.axes if ax.patches]
    assert shapes
    assert all(ax.get_aspect() == 1 for ax in shapes)


def test_points_of_ones_own(tmp_path, run):
    file = tmp_path / "corners.csv"
    file.write_text("x,y\n0,0\n2,0\n\n2,1  # the last\n")
    words = ("--points", str(file), "--angle", "-30", "--dpi", "30", "-o", str(tmp_path))
    status, out, _ = run(*words)
    assert (status, out) == (0, f"{tmp_path / 'figure-turned.png'}\n")
    first = (tmp_path / "figure-turned.png").read_bytes()
    for more in (["--dark"], ["--dots"], ["--angle", "30"]):
        assert run(*words, *more)[0] == 0
        assert (tmp_path / "figure-turned.png").read_bytes() != first
    assert run("--angle", "30", "--dpi", "30", "-o", str(tmp_path))[0] == 0


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("1 2\n3 4 5\n", "line 2 has 3 numbers; expected 2, as on line 1"),
        ("x;y\n1;2\n\n3;four\n", "line 4: 'four' is not a number; expected 2 numbers (x, y)"),
        ("1,2\n3,\n", "line 2: a value is missing"),
        ("1,nan\n", "line 1: nan is not finite"),
        ("x,y\n", "has no numbers; expected 2 numbers (x, y) on each line"),
        ("", "has no numbers"),
        ("1\n2\n", "line 1 has 1 number"),
    ],
)
def test_a_file_that_is_no_table_of_points(text, said, tmp_path, run):
    file = tmp_path / "points.txt"
    file.write_text(text)
    status, out, err = run("--points", str(file), "--angle", "30", "-o", str(tmp_path / "new"))
    assert (status, out) == (2, "")
    assert len(err.splitlines()) == 1
    assert "points.txt" in err
    assert said in err
    assert not (tmp_path / "new").exists()


def test_a_file_that_is_no_text_or_is_not_there(tmp_path, run):
    file = tmp_path / "points.bin"
    file.write_bytes(bytes(range(256)))
    assert "not UTF-8 text" in run("--points", str(file), "--angle", "30")[2]
    assert "No such file" in run("--points", str(tmp_path / "none"), "--angle", "30")[2]
    assert "directory" in run("--points", str(tmp_path), "--angle", "30")[2]


@pytest.mark.slow
@pytest.mark.parametrize("suffix", ["png", "svg", "pdf"])
def test_the_same_bytes_each_time(suffix, tmp_path, run, monkeypatch):
    first, second = tmp_path / "a", tmp_path / "b" / "c"
    words = ("--format", suffix, "--dpi", "60")
    assert run("-o", str(first), *words)[0] == 0
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "86400")
    assert run("-o", str(second), *words)[0] == 0
    names = [f"figure-{number}.{suffix}" for number in FIGURES]
    assert sorted(os.listdir(first)) == sorted(os.listdir(second)) == names
    for name in names:
        content = (first / name).read_bytes()
        assert content.startswith(SIGNATURE[suffix])
        assert content == (second / name).read_bytes()


def test_only_some_and_larger(tmp_path, run):
    small, large = tmp_path / "s", tmp_path / "l"
    status, out, _ = run("-o", str(small), "--only", "2.4,2.1", "--only", "2.1", "--dpi", "50")
    assert status == 0
    assert out.splitlines() == [str(small / f"figure-{n}.png") for n in ("2.1", "2.4")]
    run("-o", str(large), "--only", "2.1", "--dpi", "100")
    sizes = [
        int.from_bytes((d / "figure-2.1.png").read_bytes()[16:20], "big") for d in (small, large)
    ]
    assert abs(sizes[1] - 2 * sizes[0]) <= 1  # a width is a whole number of pixels


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("--only", "2.7"), "did you mean"),
        (("--only", ","), "names no figure"),
        (("--only", "x"), "there are 2.1"),
        (("--dpi", "0"), "20 to 1200"),
        (("--dpi", "9999999"), "20 to 1200"),
        (("--dpi", "many"), "20 to 1200"),
        (("--format", "gif"), "png"),
        (("--points", "any.csv"), "--points needs an angle"),
        (("--points", "any.csv", "--angle", "x"), "an angle in degrees"),
        (("--angle", "inf"), "an angle in degrees"),
        (("--angle", "30", "--only", "2.1"), "leave it out"),
        (("--dark",), "go with --points FILE or --angle DEGREES"),
    ],
)
def test_bad_words_give_one_line(words, said, tmp_path, run):
    status, out, err = run("-o", str(tmp_path / "new"), *words)
    assert (status, out) == (2, "")
    assert len(err.splitlines()) == 1
    assert said in err
    assert not (tmp_path / "new").exists()


def test_pictures_go_to_the_folder_that_is_named_or_here(run, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert run("--only", "2.1", "--dpi", "20")[:2] == (0, "figure-2.1.png\n")
    assert os.listdir(tmp_path) == ["figure-2.1.png"]
    status, _, err = run("-o", "")
    assert status == 2
    assert "empty" in err


def test_a_folder_that_cannot_be_written_is_told_before_drawing(tmp_path, run, monkeypatch):
    monkeypatch.setattr(saving, "picture", lambda *_: pytest.fail("drew first"))
    file = tmp_path / "file"
    file.write_text("kept")
    for target in (file, file / "below"):
        status, _, err = run("-o", str(target))
        assert status == 2
        assert len(err.splitlines()) == 1
        assert "choose another directory" in err
    assert file.read_text() == "kept"


def test_a_failure_leaves_no_half_file(tmp_path, monkeypatch):
    def full(path, content):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(saving, "write_whole", full)
    with pytest.raises(OutputError, match="No space left"):
        saving.save(FIGURES.values(), tmp_path, dpi=20)
    monkeypatch.undo()
    target = tmp_path / "whole.png"
    target.write_bytes(b"old")
    with pytest.raises(TypeError):
        saving.write_whole(target, "no bytes")
    assert target.read_bytes() == b"old"
    assert os.listdir(tmp_path) == ["whole.png"]


def test_another_package_can_draw_by_the_same_means(tmp_path):
    mine = Drawing("3.1", "mine", (2, 2), lambda figure: figure.text(0.5, 0.5, "mine"))
    assert saving.save([mine], tmp_path, "svg") == [tmp_path / "figure-3.1.svg"]


@pytest.mark.slow
def test_no_pyplot_and_no_settings_of_the_user(tmp_path):
    code = (
        "import sys; from hfield.cli import main\n"
        "assert main(['figures', '--only', '2.1', '-o', sys.argv[1]]) == 0\n"
        "assert 'matplotlib.pyplot' not in sys.modules"
    )
    (tmp_path / "matplotlibrc").write_text("font.size: 30\naxes.facecolor: red\n")
    for name, env in (("a", {}), ("b", {"MATPLOTLIBRC": str(tmp_path), "MPLBACKEND": "svg"})):
        words = [sys.executable, "-c", code, str(tmp_path / name)]
        subprocess.run(
            words, check=True, capture_output=True, env={**os.environ, **env}, timeout=PATIENCE
        )
    both = [(tmp_path / name / "figure-2.1.png").read_bytes() for name in "ab"]
    assert both[0] == both[1]
