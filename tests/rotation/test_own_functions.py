"""`rotation.benchmark` and `hfield bench --own`: own functions are checked, then timed. No times here."""

import json

import numpy as np
import pytest

from hfield.cli import main
from rotation import RotationError, benchmark, rotate, rotate_euler
from rotation.bench import user_benchmark
from rotation.bench.measure import Settings
from rotation.bench.ways import WAYS
from rotation.bench.ways.user_functions import OwnFileError, OwnFunctionError, functions_of, own_way
from rotation.commands.bench import BLAS

TINY = {"frames": 3, "repeats": 2, "seconds": 0.001, "threads": 1}
LINE = r"test_own_functions\.py, line \d+: f, test 1: "
MINE = """
def helper(x):
    return x

def mine(points, axis, angle):
    print("from mine")
    return rotate(points, axis, angle)

def matrices(points, angles):
    return rotate_euler(points, angles, "ZYX")

def _private(points, axis, angle):
    return points
"""


def mine(points, axis, angle):
    return rotate(points, axis, angle)


def matrices(points, angles):
    return rotate_euler(points, angles, "ZYX")


@pytest.fixture
def few(monkeypatch):
    """Only the copy beside one's own."""
    monkeypatch.setattr(user_benchmark, "WAYS", WAYS[:1])


@pytest.fixture
def run(capsys, monkeypatch, few, tmp_path):
    """Run `hfield bench --own` on a file with a text: (status, stdout, stderr)."""
    for name in BLAS:
        monkeypatch.setenv(name, "2")

    def call(text, *words):
        file = tmp_path / "mine.py"
        file.write_text(text)
        sizes = ("--points", "40", "--frames", "4", "--repeats", "2", "--quick", "--threads", "1")
        status = main(["bench", *sizes, "--own", str(file), *words])
        out, err = capsys.readouterr()
        assert "Traceback" not in err
        return status, out, "".join(x for x in err.splitlines(True) if "numpy was imp" not in x)

    return call


def test_rows_have_ones_own_function_beside_the_others():
    rows = benchmark(points=60, ways={"mine": mine}, **TINY).rows
    assert [row["way"] for row in rows][:3] == ["copy (np.copyto)", "mine", "hfield, (N, 3)"]
    row = rows[1]
    assert (row["test"], row["status"], row["points"], row["library"]) == ("1", "ok", 60, "")
    assert len(row["samples_ms"]) == 2
    assert 0 < row["best_frame_ms"] <= row["mean_ms"]
    assert row["error"] < 1e-13


@pytest.mark.parametrize("threads", [1, 3])
def test_every_test_of_the_thesis(few, threads):
    found = benchmark(
        points=60, ways={"mine": mine, "ours": matrices}, test="2", **(TINY | {"threads": threads})
    )
    own_rows = [
        (row["test"], row["way"], row["status"]) for row in found.rows if not row["library"]
    ]
    assert own_rows == [
        ("2 quaternion, as printed", "mine", "ok"),
        ("2 quaternion, own axes", "mine", "ok"),
        ("2 matrix", "ours", "ok"),
    ]
    assert "Test 2, matrix model" in str(found)


def test_points_of_ones_own(few):
    seen = []

    def spy(points, axis, angle):
        seen.append(np.array(points))
        return rotate(points, axis, angle)

    cloud = 1e6 * np.random.default_rng(1).standard_normal((7, 3))
    rows = benchmark(cloud, ways={"spy": spy}, **TINY).rows
    assert rows[1]["points"] == 7
    assert all(np.array_equal(points, cloud) for points in seen)


def turned_but_one(points, axis, angle):
    turned = rotate(points, axis, angle)
    turned[5] += [0, 0, 1e-6]
    return turned


@pytest.mark.parametrize(
    ("function", "said"),
    [
        (turned_but_one, LINE + r"point 5 of 60, \(.* came out as .* expected .* off by 1\.0e-06"),
        (lambda points, axis, angle: -points, "point 0 of 60"),
        (lambda points, axis, angle: points * np.nan, r"came out as \(nan, nan, nan\)"),
        (lambda points, axis, angle: rotate(points, axis, -angle), "point 0 of 60"),
        (lambda points, axis, angle: points.T, r"the shape \(3, 60\); expected the shape \(60, 3\)"),
        (lambda points, axis, angle: points[0], "the shape"),
        (lambda points, axis, angle: None, "is not an array of points"),
        (lambda points, axis, angle: [["a"]], "is not an array of points"),
        (lambda points, axis, angle: points + 1j, "is not an array of points"),
        (lambda points, axis, angle: points.fill(1), LINE + "ValueError: .*read-only"),
        (lambda points, axis, angle: axis.fill(1), "read-only"),
        (lambda points: points, "line .*: f, test 1: TypeError"),
        (len, "f, test 1: TypeError"),
        (lambda points, axis, angle: 1 // 0, LINE + "ZeroDivisionError"),
    ],
)  # fmt: skip
def test_a_function_that_is_wrong_or_fails_is_named_before_anything_is_timed(
    function, said, monkeypatch
):
    monkeypatch.setattr(user_benchmark, "run_test", lambda *_: pytest.fail("timed first"))
    with pytest.raises(OwnFunctionError, match=said):
        benchmark(points=60, ways={"f": function}, **TINY)


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ({"points": 0}, "points is 0"),
        ({"points": [[1, 2]]}, "points"),
        ({"points": [[1, 2, np.nan]]}, "row 0 is not finite"),
        ({"points": np.empty((0, 3))}, "n at least 1"),
        ({"frames": 1.5}, "frames is 1.5"),
        ({"threads": 0}, "threads is 0"),
        ({"seconds": 0}, "seconds is 0"),
        ({"test": "3"}, "test '3'"),
        ({"ways": {"scipy": mine}}, "already a way called 'scipy'"),
        ({"ways": {"m": matrices}}, "which was not chosen"),
    ],
)
def test_arguments_that_do_not_fit(words, said):
    with pytest.raises(RotationError, match=said):
        benchmark(**({"points": 10} | TINY | words))


def test_a_slow_function_is_timed_on_a_part(few, monkeypatch):
    monkeypatch.setattr(user_benchmark, "SLOW_POINTS", 5)
    ticks = iter(range(100))
    monkeypatch.setattr(user_benchmark, "perf_counter", lambda: next(ticks))
    tests = user_benchmark.chosen_tests("1")
    (_, way) = user_benchmark.with_own(
        {"mine": mine}, tests, Settings(points=60, frames=3, seconds=1.5)
    )
    assert way.slow
    (_, way) = user_benchmark.with_own(
        {"mine": mine}, tests, Settings(points=60, frames=3, seconds=15)
    )
    assert not way.slow


def test_functions_of_a_file_are_told_by_their_parameters(tmp_path):
    file = tmp_path / "mine.py"
    file.write_text("from rotation import rotate, rotate_euler\nfrom numba import njit\n" + MINE +
                    "\n@njit\ndef quick(points, axis, angle, power=1):\n    return points\n")  # fmt: skip
    found = functions_of(file)
    assert list(found) == ["mine", "matrices", "quick"]
    kinds = [set(own_way(name, function).makes) for name, function in found.items()]
    assert kinds == [{"one axis", "own axis"}, {"euler"}, {"one axis", "own axis"}]


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("x = 1\ndef f(:\n", r"mine\.py, line 2: invalid syntax"),
        ("import json\njson.loads('{')\n", r"mine\.py, line 2: JSONDecodeError"),
        ("import sys\nsys.exit(3)\n", r"mine\.py, line 2: SystemExit: 3"),
        ("open('there is none')\n", r"mine\.py, line 1: FileNotFoundError"),
        ("x: none = 1\n", r"mine\.py, line 1: NameError"),  # its own `from __future__`, not ours
        ("def f(a, b): return a\n", r"defines no function .*it defines f\(a, b\)"),
        ("from rotation import rotate\n", "defines no function"),
        ("\0", r"mine\.py: source code string cannot contain null bytes"),
        ("# coding: none\n", r"mine\.py"),
    ],
)
def test_files_that_have_no_functions(text, said, tmp_path):
    file = tmp_path / "mine.py"
    file.write_text(text)
    with pytest.raises(OwnFileError, match=said):
        functions_of(file)
    with pytest.raises(OwnFileError, match="could not be read"):
        functions_of(tmp_path / "none.py")


def test_the_command_times_a_file_and_keeps_what_it_prints_out_of_the_json(run, tmp_path):
    (tmp_path / "beside.py").write_text("from rotation import rotate, rotate_euler\n")
    status, out, err = run("from beside import *\n" + MINE, "--format", "json")
    assert status == 0
    assert "from mine" in err
    results = [(r["way"], r["status"]) for r in json.loads(out)["results"] if not r["library"]]
    assert results == [("mine", "ok"), ("mine", "ok"), ("mine", "ok"), ("matrices", "ok")]


@pytest.mark.parametrize(
    ("text", "status", "said"),
    [
        (
            "def f(points, axis, angle):\n    return points\n",
            1,
            "mine.py, line 1: f, test 1: point 0",
        ),
        (
            "def f(points, axis, angle):\n\n    return 1 / 0\n",
            1,
            "mine.py, line 3: f, test 1: ZeroD",
        ),
        ("def f(points, axis):\n    return points\n", 2, "it defines f(points, axis)"),
        ("1 / 0\n", 2, "mine.py, line 1: ZeroDivisionError: division by zero"),
    ],
)
def test_faults_of_a_file_are_one_line(run, text, status, said):
    found, out, err = run(text)
    assert (found, out) == (status, "")
    assert len(err.splitlines()) == 1
    assert said in err


def test_the_chart_shows_ones_own(run, tmp_path):
    text = "from rotation import rotate, rotate_euler\n" + MINE
    assert (
        run(text, "--test", "1", "--plot", str(tmp_path / "chart.svg"))[0] == 2
    )  # matrices: test 2
    text = text.replace("def matrices", "def _matrices")
    assert run(text, "--test", "1", "--plot", str(tmp_path / "chart.svg"))[0] == 0
    assert b"<!-- mine -->" in (tmp_path / "chart.svg").read_bytes()
