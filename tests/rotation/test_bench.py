"""`hfield bench`: every way computes the same, and the report says what was measured. No times here."""

import gc
import json
from dataclasses import replace

import numpy as np
import pytest

from hfield.cli import main
from rotation.bench import measure, user_benchmark, ways
from rotation.bench.measure import TOLERANCE, Settings, run_test
from rotation.bench.results import as_json, ratios_of, table
from rotation.bench.tasks import TESTS
from rotation.bench.ways import WAYS
from rotation.bench.ways.way import Way
from rotation.commands.bench import BLAS
from tests.subcases import subcases

TINY = Settings(points=40, frames=4, repeats=2, seconds=0.001)
BY_NAME = {test.name: test for test in TESTS}
TEST_1, ITSELF, OWN, EULER = TESTS


@pytest.fixture(scope="module", autouse=True)
def _little_to_collect():
    """Every measurement collects garbage first: it need not look at what other tests left behind."""
    gc.collect()
    gc.freeze()


@pytest.fixture
def run(capsys, monkeypatch):
    """Run a command line with tiny sizes where it names none: (status, stdout, stderr)."""
    for name in BLAS:
        monkeypatch.setenv(name, "2")  # and put back after the command has set it

    def call(*words, tiny=True):
        sizes = ("--points", "40", "--frames", "4", "--repeats", "2", "--quick") if tiny else ()
        status = main(["bench", *sizes, *words])
        out, err = capsys.readouterr()
        assert "Traceback" not in err
        return status, out, err

    return call


def spoilt(name="spoilt", role="peer", **changes):
    """A way that returns the points turned by nothing at all."""
    made = {kind: lambda task: lambda n: task.points for kind in ("one axis", "own axis", "euler")}
    return replace(Way(name, role, "numpy", "numpy", "new", made), **changes)


def copy():
    return ways.PLAIN[0]


@pytest.mark.slow
@pytest.mark.parametrize("threads", [1, 2])
@pytest.mark.parametrize("test", TESTS, ids=lambda test: test.name)
def test_every_way_computes_the_same(test, threads):
    results = run_test(test, WAYS, replace(TINY, threads=threads))
    assert len(results) >= 6
    for result in results:
        allowed = ("ok", "missing") if result.way.role == "peer" else ("ok",)
        assert result.status in allowed, (result.way.name, result.reason)
        if result.status == "ok":
            assert result.error <= TOLERANCE
            assert len(result.samples) == 2
            assert min(result.samples) > 0


def test_every_way_does_every_test_it_can():
    assert {kind for way in WAYS for kind in way.makes} == {"one axis", "own axis", "euler"}
    assert WAYS[0].role == "floor"
    for test in TESTS:
        kind = test.make(3, 2).kind
        assert {way.role for way in WAYS if kind in way.makes} == {
            "floor",
            "ours",
            "peer",
            "thesis",
        }


def test_the_reference_is_the_rotation_of_the_text():
    from rotation.thesis import rotationbyMatrix, rotationMatrixZYX, rotationquaternionNormalized

    one, own, euler = (test.make(5, 3) for test in (TEST_1, OWN, EULER))
    assert one.angles[:3].tolist() == [0, np.pi, 2 * np.pi]
    for i in range(5):
        turned = rotationbyMatrix(rotationMatrixZYX(1.0, 0.0, 0.0), one.points[i].tolist())
        assert np.allclose(one.expected(one.check)[i], turned, rtol=0, atol=1e-14)
        angle, axis, point = own.angles[2 + i], own.axes[i].tolist(), own.points[i].tolist()
        turned = rotationquaternionNormalized(angle, axis, point)
        assert np.allclose(own.expected(2)[i], turned, rtol=0, atol=1e-14)
        point = euler.points[i].tolist()
        turned = rotationbyMatrix(rotationMatrixZYX(*point), point)
        assert np.allclose(euler.expected(0)[i], turned, rtol=0, atol=1e-14)


def test_points_are_random_numbers_and_a_part_is_a_part():
    task = OWN.make(1000, 7)
    assert 0 <= task.points.min() < 0.01 < 0.99 < task.points.max() < 1
    assert np.array_equal(task.points, OWN.make(1000, 7).points)
    part = task.part(10, 30)
    for frame in (0, 6, task.check):
        assert np.array_equal(part.expected(frame), task.expected(frame)[10:30])


def test_as_printed_nothing_moves_and_with_axes_of_their_own_points_do():
    moved = {
        test.name: max(r.moved for r in run_test(test, WAYS, TINY) if r.way.rotates)
        for test in (ITSELF, OWN)
    }
    assert moved[ITSELF.name] < 1e-14
    assert moved[OWN.name] > 0.1
    text = table(run_test(ITSELF, WAYS, TINY), TINY)
    assert "so nothing moves" in text
    assert "largest displacement of a coordinate over all ways is" in text


@subcases("test", [TEST_1, OWN, EULER])
@subcases("frames", [1, 2, 3, 5])
def test_a_way_that_does_other_work_is_not_timed(test, frames):
    results = run_test(test, [copy(), spoilt()], replace(TINY, frames=frames))
    assert [r.status for r in results] == ["ok", "wrong"]
    assert results[1].samples == []
    assert "off by" in results[1].reason
    assert "not timed: point 0 of 40" in table(results, TINY)


def test_a_way_that_gives_nan_is_wrong():
    nan = {"one axis": lambda task: lambda n: np.full_like(task.points, np.nan)}
    assert run_test(TEST_1, [spoilt(makes=nan)], TINY)[0].status == "wrong"


def test_a_peer_that_is_not_installed_is_named_with_a_hint():
    gone = spoilt("gone", module="a_library_that_nobody_has", distribution="gone-library")
    results = run_test(TEST_1, [copy(), gone], TINY)
    assert (results[1].status, results[1].samples) == ("missing", [])
    text = table(results, TINY)
    assert "Not installed: gone-library. To compare with them: pip install 'hfield[bench]'" in text
    assert as_json(results, TINY)["missing"] == ["gone-library"]


def test_a_peer_that_fails_is_a_row_but_our_own_fault_is_raised():
    def make(task):
        raise OverflowError("too much")

    results = run_test(TEST_1, [spoilt(makes={"one axis": make})], TINY)
    assert (results[0].status, results[0].reason) == ("failed", "OverflowError: too much")
    with pytest.raises(OverflowError):
        run_test(TEST_1, [spoilt(role="ours", makes={"one axis": make})], TINY)


def test_the_slow_way_runs_on_a_part_and_says_so(monkeypatch):
    monkeypatch.setattr(measure, "SLOW_POINTS", 10)
    seen = set()

    def make(task):
        def frame(n):
            seen.add(len(task.points))
            return task.expected(n)

        return frame

    slow = spoilt("slow", slow=True, makes={"one axis": make})
    results = run_test(TEST_1, [copy(), slow], TINY)
    assert seen == {10}
    assert (results[1].points, results[1].scale) == (10, 4.0)
    assert "on 10 points, scaled by 4" in table(results, TINY)


def test_samples_are_scaled_to_all_points_and_to_one_frame(monkeypatch):
    monkeypatch.setattr(measure, "SLOW_POINTS", 10)
    monkeypatch.setattr(measure, "_times", lambda frame, chosen: [0.25] * len(chosen))
    right = spoilt("right", slow=True, makes={"one axis": lambda task: task.expected})
    (result,) = run_test(TEST_1, [right], replace(TINY, seconds=100.0))
    assert result.samples == [1.0, 1.0]
    assert result.best == 1.0
    assert result.frames == 4
    (short,) = run_test(TEST_1, [right], replace(TINY, frames=100, seconds=5.0))
    assert short.frames == 10
    assert "on 10 frames" in table([short], replace(TINY, frames=100))


def test_the_json_says_everything():
    results = run_test(TEST_1, WAYS, TINY)
    data = json.loads(json.dumps(as_json(results, TINY)))
    assert data["schema"] == "hfield-bench/1"
    assert {"processor", "cores", "system", "python", "numpy", "numba"} <= set(data["machine"])
    assert data["settings"] == {
        "points": 40, "frames": 4, "repeats": 2, "threads": 1, "dtype": "float64"
    }  # fmt: skip
    assert len(data["results"]) == len(results)
    timed = [entry for entry in data["results"] if entry["status"] == "ok"]
    assert {"copy (np.copyto)", "hfield, (N, 3)", "plain numpy"} <= {e["way"] for e in timed}
    for entry in timed:
        samples = entry["samples_ms"]
        assert 0 < entry["best_frame_ms"] <= entry["min_ms"] == min(samples)
        assert entry["mean_ms"] == pytest.approx(sum(samples) / len(samples))
        assert min(samples) <= entry["median_ms"] <= max(samples)
        assert entry["library_version"]
    best = {entry["way"]: entry["best_frame_ms"] for entry in timed}
    for entry in timed:
        assert entry["ratio_to_copy"] == pytest.approx(
            entry["best_frame_ms"] / best["copy (np.copyto)"]
        )
        assert entry["ratio_to_hfield"] == pytest.approx(
            entry["best_frame_ms"] / best["hfield, (N, 3)"]
        )


def test_ratios_need_something_to_compare_with():
    (alone,) = run_test(TEST_1, [spoilt(rotates=False)], TINY)
    assert ratios_of(alone, [alone]) == (None, None)


def test_threads_are_put_back():
    from rotation.kernels import threads

    before = threads()
    run_test(TEST_1, WAYS[:2], replace(TINY, threads=3))
    assert threads() == before


def test_the_command_prints_a_table(run):
    status, out, err = run("--threads", "1")
    assert status == 0
    for test in TESTS:
        assert test.title in out
    assert "40 points of float64, 4 frames, 2 repeats, 1 thread for every way" in out
    assert "numpy was imported before" in err


def test_all_processors_work_by_default(run):
    from rotation.kernels import threads

    out = run("--test", "1", "--format", "json")[1]
    assert json.loads(out)["settings"]["threads"] == threads()


@pytest.mark.parametrize(("number", "count"), [("1", 1), ("2", 3)])
def test_one_test_alone_as_json_in_a_file(number, count, run, tmp_path):
    target = tmp_path / "bench.json"
    status, out, _ = run("--test", number, "--format", "json", "-o", str(target))
    assert (status, out) == (0, "")
    data = json.loads(target.read_text(encoding="utf-8"))
    assert [t["test"][0] for t in data["tests"]] == [number] * count


def test_a_wrong_way_gives_status_1(run, monkeypatch):
    monkeypatch.setattr(user_benchmark, "WAYS", (copy(), spoilt()))
    status, out, err = run("--test", "1")
    assert status == 1
    assert "not timed" in out
    assert "spoilt: wrong" in err


def test_the_chart(run, tmp_path):
    target = tmp_path / "new" / "chart.svg"
    assert run("--test", "1", "--plot", str(target))[0] == 0
    assert target.read_bytes().startswith(b"<?xml")
    assert [path.name for path in target.parent.iterdir()] == ["chart.svg"]


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("--points", "0"), "1 to 10000000"),
        (("--points", "-5"), "1 to 10000000"),
        (("--points", "99999999999"), "1 to 10000000"),
        (("--points", "9" * 5000), "1 to 10000000"),
        (("--points", "1e3"), "1 to 10000000"),
        (("--frames", "0"), "1 to 100000"),
        (("--repeats", "none"), "1 to 1000"),
        (("--threads", "0"), "1 to 256"),
        (("--test", "3"), "'3'"),
        (("--plot", "chart"), ".svg"),
        (("--plot", "chart.bmp"), ".svg"),
        (("--plot", ""), ".svg"),
        (("--plot", "/dev/null/chart.png"), "choose another"),
        (("-o", "/dev/null/bench.txt"), "choose another"),
    ],
)
def test_bad_words_give_one_line_before_any_work(words, said, run, monkeypatch):
    monkeypatch.setattr(measure, "run_test", lambda *_: pytest.fail("worked first"))
    status, out, err = run(*words, tiny=False)
    assert (status, out) == (2, "")
    error = [line for line in err.splitlines() if "note:" not in line]
    assert len(error) == 1
    assert said in error[0]


@pytest.mark.parametrize("words", [("--points", "1"), ("--frames", "1"), ("--threads", "5")])
def test_the_smallest_sizes(words, run):
    assert run(*words)[0] == 0
