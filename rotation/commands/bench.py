"""``hfield bench``: the benchmark of the thesis (3.2) for many implementations."""

from __future__ import annotations

import os
import sys
from argparse import ArgumentParser, Namespace
from contextlib import ExitStack, redirect_stdout
from functools import partial
from pathlib import Path

from hfield.cli.output import note, open_output, say
from hfield.cli.parser import add_format, add_output, whole
from hfield.cli.status import Progress

SUMMARY = "time rotations beside scipy and other libraries"
HEADING = "Rotation and film"
HELP = (
    "Repeat the benchmark of section 3.2 of the thesis: rotate 550000 points over 300 "
    "frames with hfield, scipy, quaternionic, numpy-quaternion, plain numpy and the "
    "functions of the thesis. Copying the array gives the lower bound. Each library's "
    "result is checked before it is timed. Slow ones are timed on a part, and the output "
    "says so. --own FILE.py adds the functions of a file. A function with the parameters "
    "(points, axis, angle) returns the points (n, 3) turned about the axis by the angle in "
    "radians. In test 1 there is one axis (3,) and one angle, a float; in test 2 each point has "
    "its own, (n, 3) and (n,). A function with the parameters (points, angles) does the matrix "
    "test: it turns point i by R_z(a) R_y(b) R_x(c), where (a, b, c) is row i of the angles. "
    "Exit status: 0; 1 if a result was wrong or failed; 2 bad usage."
)
EXAMPLES = (
    "hfield bench --quick",
    "hfield bench --test 1 --plot chart.svg",
    "hfield bench --test 1 --quick --own mine.py",
)
MAX_POINTS = 10_000_000  # about 6 GB with the libraries that need most
FULL, QUICK = (300, 10, 1.5), (30, 3, 0.12)  # frames, repeats, seconds for one way in one test
BLAS = ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS", "VECLIB_MAXIMUM_THREADS")


def configure(parser: ArgumentParser) -> None:
    """Declare the arguments."""
    add = parser.add_argument
    add("--test", choices=("1", "2"), metavar="1|2", help="only this test (default: both)")
    points, frames, repeats, threads = (whole(1, most) for most in (MAX_POINTS, 100_000, 1000, 256))
    add(
        "--points",
        type=points,
        default=550_000,
        metavar="N",
        help="number of points (default: 550000)",
    )
    add("--frames", type=frames, metavar="N", help="frames of a run (default: 300; quick: 30)")
    add("--repeats", type=repeats, metavar="N", help="runs of each library (default: 10; quick: 3)")
    add(
        "--threads",
        type=threads,
        metavar="N",
        help="threads of each library (default: all processors)",
    )
    add("--quick", action="store_true", help="a rough answer in about 15 seconds instead of 70")
    add(
        "--own",
        metavar="FILE.py",
        help="also check and time the functions of this file (see above)",
    )
    add("--plot", metavar="FILE", help="also draw a bar chart to FILE, a .png, .svg or .pdf")
    add_format(parser, "table", "json")
    add_output(parser)


def run(args: Namespace) -> int:
    """Measure, report, and return the exit status."""
    _one_thread_for_blas()
    from rotation.bench.chart import try_chart, write_chart
    from rotation.bench.measure import Settings, run_test
    from rotation.bench.results import as_json, table
    from rotation.bench.user_benchmark import chosen_tests, with_own
    from rotation.bench.ways.user_functions import OwnFunctionError, functions_of, importing_from
    from rotation.kernels import threads as available

    frames, repeats, seconds = QUICK if args.quick else FULL
    settings = Settings(
        args.points,
        args.frames or frames,
        args.repeats or repeats,
        args.threads or available(),
        seconds,
    )
    chart = None if args.plot is None else try_chart(args.plot)
    replace = chart is not None and chart.exists()
    tests = chosen_tests(args.test)
    with open_output(args.output) as out, ExitStack() as stack:
        functions = {}
        if args.own is not None:
            stack.enter_context(redirect_stdout(sys.stderr))  # the output of the functions
            stack.enter_context(importing_from(Path(args.own).parent))
            functions = functions_of(Path(args.own))
        try:
            ways = with_own(functions, tests, settings)
        except OwnFunctionError as error:
            say("error", str(error))
            return 1
        results = []
        with Progress("tests") as progress:
            for done, test in enumerate(tests):
                results += run_test(test, ways, settings, partial(progress, done, len(tests)))
        if args.format == "json":
            out.write_json(as_json(results, settings))
        else:
            out.write(table(results, settings))
    if chart is not None:
        write_chart(results, settings, chart, replace)
    bad = [result for result in results if result.status in ("wrong", "failed")]
    for result in bad:
        note(f"{result.test.name}, {result.way.name}: {result.status}, {result.reason}")
    return int(bool(bad))


def _one_thread_for_blas() -> None:
    """Limit numpy's matrix products to one thread, because ``--threads`` threads share the points.

    The libraries read these variables when numpy is imported.
    """
    if "numpy" in sys.modules:
        note("numpy was imported before; its matrix products may use more threads than --threads")
    os.environ.update(dict.fromkeys(BLAS, "1"))
