"""The results as a table and as JSON."""

from __future__ import annotations

import os
import platform
from collections.abc import Iterable, Sequence
from itertools import groupby

import numpy as np

from rotation.bench.measure import Result, Settings

SCHEMA = "hfield-bench/1"
HINT = "pip install 'hfield[bench]'"


def table(results: Sequence[Result], settings: Settings) -> str:
    """Lay out the results in columns, one table per test."""
    s = settings
    lines = [
        f"{s.points} points of float64, {counted(s.frames, 'frame')}, "
        f"{counted(s.repeats, 'repeat')}, {counted(s.threads, 'thread')} for every way",
        machine_line(),
        "Times are for a frame of all points: the mean of all repeats, and the best frame. Ratios are",
        "of the best, to the copy and to hfield's (N, 3) call. A run is the mean times the frames.",
    ]
    for test, group in groupby(results, key=lambda result: result.test):
        rows = list(group)
        said = [f"  The thesis printed {test.printed}."] if test.printed else []
        lines += ["", test.title, f"  {test.what}", *said, *_rows(rows, s)]
        if test.name == "2 quaternion, as printed":
            moved = max((r.moved for r in rows if r.frames and r.way.rotates), default=0.0)
            lines.append(
                f"  The largest displacement of a coordinate over all ways is {moved:.1e}."
            )
    if absent := missing(results):
        lines += ["", f"Not installed: {', '.join(absent)}. To compare with them: {HINT}"]
    return "\n".join(lines)


def counted(number: int, thing: str) -> str:
    """Return ``3 frames``, ``1 frame``."""
    return f"{number} {thing}{'' if number == 1 else 's'}"


def missing(results: Iterable[Result]) -> list[str]:
    """Return the names of the libraries that were not found."""
    return list(dict.fromkeys(r.way.distribution for r in results if r.status == "missing"))


def _rows(results: Sequence[Result], settings: Settings) -> list[str]:
    head = ("way", "ms, mean", "ms, best", "× copy", "× hfield", "run, s", "into", "remark")
    body = [head, *(_row(r, results, settings) for r in results if r.status != "missing")]
    wide = [max(len(row[n]) for row in body) for n in range(len(head))]
    return [
        "  "
        + "  ".join(
            f"{cell:<{w}}" if n in (0, 6, 7) else f"{cell:>{w}}"
            for n, (cell, w) in enumerate(zip(row, wide, strict=True))
        ).rstrip()
        for row in body
    ]


def _row(result: Result, results: Sequence[Result], settings: Settings) -> tuple[str, ...]:
    name = result.way.name
    if result.status != "ok":
        return (name, *[""] * 6, f"not timed: {result.reason}")
    run = result.mean * settings.frames
    ratios = ["" if x is None else f"{x:.2f}" for x in ratios_of(result, results)]
    return (
        name,
        _milliseconds(result.mean),
        _milliseconds(result.best),
        *ratios,
        f"{run:.3g}" if run < 1000 else f"{run:.0f}",
        "out" if result.way.writes == "out" else "new",
        remark(result, settings),
    )


def _milliseconds(seconds: float) -> str:
    """Format milliseconds with two decimals, or with three digits if below a tenth."""
    ms = 1e3 * seconds
    return f"{ms:.2f}" if ms >= 0.1 else f"{ms:#.3g}"


def remark(result: Result, settings: Settings) -> str:
    """Return a remark on the part of the work that was timed, if not all of it."""
    parts = []
    if result.points < settings.points:
        parts.append(f"on {result.points} points, scaled by {result.scale:.4g}")
    if result.frames < settings.frames:
        parts.append(f"on {counted(result.frames, 'frame')}")
    if len(result.samples) < settings.repeats:
        parts.append(counted(len(result.samples), "repeat"))
    return ", ".join(parts)


def ratios_of(result: Result, results: Sequence[Result]) -> tuple[float | None, float | None]:
    """Return the ratios of the best time to the best times of the copy and of our (N, 3) call in the same
    test.
    """

    def over(role: str) -> float | None:
        base = next((r for r in results if r.way.role == role and r.samples), None)
        return result.best / base.best if base is not None else None

    return over("floor"), over("ours")


def as_json(results: Sequence[Result], settings: Settings) -> dict[str, object]:
    """Return all measurements including all samples, with times in milliseconds per frame."""
    from hfield import __version__

    tests = list(dict.fromkeys(r.test for r in results))
    return {
        "schema": SCHEMA,
        "version": __version__,
        "machine": machine(),
        "settings": {
            "points": settings.points,
            "frames": settings.frames,
            "repeats": settings.repeats,
            "threads": settings.threads,
            "dtype": "float64",
        },
        "missing": missing(results),
        "tests": [
            {"test": t.name, "title": t.title, "what": t.what, "printed": t.printed} for t in tests
        ],
        "results": as_rows(results),
    }


def as_rows(results: Sequence[Result]) -> list[dict[str, object]]:
    """Return one dict for each result, with times in milliseconds per frame."""
    return [_entry(r, [other for other in results if other.test is r.test]) for r in results]


def _entry(result: Result, results: Sequence[Result]) -> dict[str, object]:
    entry: dict[str, object] = {
        "test": result.test.name,
        "way": result.way.name,
        "library": result.way.distribution,
        "library_version": result.version,
        "status": result.status,
    }
    if result.status != "ok":
        return entry | {"reason": result.reason}
    copy, ours = ratios_of(result, results)
    return entry | {
        "writes": result.way.writes,
        "points": result.points,
        "frames": result.frames,
        "scale": result.scale,
        "error": result.error,
        "moved": result.moved,
        "best_frame_ms": 1e3 * result.best,
        "min_ms": 1e3 * min(result.samples),
        "median_ms": 1e3 * result.median,
        "mean_ms": 1e3 * result.mean,
        "ratio_to_copy": copy,
        "ratio_to_hfield": ours,
        "samples_ms": [1e3 * sample for sample in result.samples],
    }


def machine() -> dict[str, object]:
    """Return the machine data that affect the times: processor, system, versions."""
    import numba

    return {
        "processor": processor(),
        "cores": os.cpu_count(),
        "system": platform.system(),
        "architecture": platform.machine(),
        "python": platform.python_version(),
        "numpy": np.__version__,
        "numba": numba.__version__,
    }


def machine_line() -> str:
    """Return the machine data on one line."""
    m = machine()
    return (
        f"{m['processor']}, {m['cores']} cores; Python {m['python']}, numpy {m['numpy']}, "
        f"numba {m['numba']}"
    )


def processor() -> str:
    """Return the name of the processor, if the system gives one."""
    try:
        with open("/proc/cpuinfo", encoding="utf-8", errors="replace") as lines:
            names = (
                line.partition(":")[2].strip() for line in lines if line.startswith("model name")
            )
            return next(names, "") or platform.processor() or platform.machine()
    except OSError:
        return platform.processor() or platform.machine()
