"""Measure what share of random faults the quick and the full test suite notice.

    python scripts/mutation_sample.py reach --seeds 1 2         # which tests reach which mutant
    python scripts/mutation_sample.py run --seed 1 -o first.json

A mutant is one of the three packages with one operator, comparison, constant or condition changed at a
place drawn by the seed. It is tried by the tests that reach the changed place, the fastest first. If the
quick tests notice nothing, the slow tests follow. docs/developers/mutation.md has the scores.

Both commands start each file of tests, or each mutant, in a fork of a process that has imported the large
libraries but none of the three packages. They need a system that forks, such as Linux.
"""

import argparse
import ast
import contextlib
import importlib
import json
import os
import random
import resource
import shutil
import signal
import sys
import tempfile
import time
import traceback
from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator, Sequence
from pathlib import Path
from typing import NamedTuple

import pytest

ROOT = Path(__file__).parents[1]
PACKAGES = ("hfield", "rotation", "anim")
REACH = ROOT / "build" / "reach.json"
COMPARISONS = {
    ast.Lt: ast.LtE, ast.LtE: ast.Lt, ast.Gt: ast.GtE, ast.GtE: ast.Gt, ast.Eq: ast.NotEq,
    ast.NotEq: ast.Eq, ast.In: ast.NotIn, ast.NotIn: ast.In, ast.Is: ast.IsNot, ast.IsNot: ast.Is,
}  # fmt: skip
OPERATORS = {
    ast.Add: ast.Sub, ast.Sub: ast.Add, ast.Mult: ast.Add, ast.Div: ast.Mult,
    ast.FloorDiv: ast.Mult, ast.Mod: ast.FloorDiv, ast.Pow: ast.Mult, ast.LShift: ast.RShift,
    ast.RShift: ast.LShift, ast.BitAnd: ast.BitOr, ast.BitOr: ast.BitAnd, ast.BitXor: ast.BitAnd,
}  # fmt: skip
OPTIONS = "tests/subcases.py"  # a file beside the conftest.py that knows --runslow
FIRST_TESTS = 15  # tests of different functions that try a mutant before the others
QUICK_SECONDS, SLOW_SECONDS = 20, 30  # of computing that the tests of one mutant may take
SPARE_SECONDS = 20  # in addition to five times the time of the tests without a mutant
MAX_BYTES = 8 << 30  # of memory
PRELOADED = (
    "numpy",
    "sympy",
    "flint",
    "galois",
    "matplotlib.figure",
    "scipy.spatial",
)
COMPILED = (
    b"from anim.compiling import"  # in files that numba compiles, as hfield/core/product.py is
)
PROBE = """
import builtins, os

def __probed__(n, value, seen=set(), log=os.environ.get("PROBE_LOG")):
    if n not in seen and log:
        seen.add(n)
        with open(log, "ab", buffering=0) as file:
            file.write(b"%d\\n" % n)
    return value

builtins.__probed__ = __probed__
"""


# -- mutants


class Mutant(NamedTuple):
    """A change at one place of one file; ``span`` are the byte offsets of its start and end."""

    file: str
    line: int
    span: tuple[int, int]
    change: str
    source: bytes

    @property
    def place(self) -> str:
        """Return a name of the place."""
        return f"{self.file}:{self.span[0]}-{self.span[1]}"

    @property
    def compiled(self) -> bool:
        """Whether numba compiles functions of this file."""
        return COMPILED in self.source or self.file == "hfield/core/product.py"


def is_typing(node: ast.AST) -> bool:
    return isinstance(node, ast.If) and ast.unparse(node.test) == "TYPE_CHECKING"


def places(tree: ast.Module) -> Iterator[ast.AST]:
    """Yield the nodes inside functions that a mutant may change.

    Annotations, messages, decorators and patterns are left alone.
    """
    todo: list[tuple[ast.AST, bool]] = [(tree, False)]
    while todo:
        node, inside = todo.pop()
        untouched = (ast.Raise, ast.JoinedStr, ast.Assert, ast.pattern)
        if is_typing(node) or isinstance(node, untouched):
            continue
        if inside and changed(node):
            yield node
        inside |= isinstance(node, (ast.FunctionDef, ast.Lambda))
        for name, value in ast.iter_fields(node):
            if name in ("annotation", "returns", "decorator_list", "ops"):
                continue
            children = value if isinstance(value, list) else [value]
            todo += [(child, inside) for child in children if isinstance(child, ast.AST)]


def changed(node: ast.AST, step: int = 1) -> tuple[ast.expr, str] | None:
    """Return the expression to replace at a node and its replacement; None if there is none."""
    match node:
        case ast.Compare(left=left, ops=[op], comparators=right) if type(op) in COMPARISONS:
            return node, ast.unparse(ast.Compare(left, [COMPARISONS[type(op)]()], right))
        case ast.BinOp(left=left, op=op, right=right) if type(op) in OPERATORS:
            return node, ast.unparse(ast.BinOp(left, OPERATORS[type(op)](), right))
        case ast.BoolOp(op=op, values=values):
            other = ast.Or() if isinstance(op, ast.And) else ast.And()
            return node, ast.unparse(ast.BoolOp(other, values))
        case ast.UnaryOp(op=ast.Not(), operand=operand):
            return node, f"bool({ast.unparse(operand)})"
        case ast.UnaryOp(op=ast.USub(), operand=operand):
            return node, f"+({ast.unparse(operand)})"
        case ast.Constant(value=bool(value)):
            return node, str(not value)
        case ast.Constant(value=int(value)):
            return node, str(value + step)
        case ast.If(test=test) | ast.IfExp(test=test) | ast.While(test=test):
            return test, f"not ({ast.unparse(test)})"
    return None


def span_of(source: bytes, node: ast.expr) -> tuple[int, int]:
    """Return the byte offsets of the start and end of a node."""
    starts = [0]
    for line in source.splitlines(keepends=True):
        starts.append(starts[-1] + len(line))
    assert node.end_lineno is not None
    assert node.end_col_offset is not None
    return starts[node.lineno - 1] + node.col_offset, starts[
        node.end_lineno - 1
    ] + node.end_col_offset


def draw(count: int, seed: int) -> list[Mutant]:
    """Return ``count`` mutants of the working tree; no mutant changes the numbers of lines."""
    rng = random.Random(seed)
    files = [path for package in PACKAGES for path in sorted((ROOT / package).rglob("*.py"))]
    sources = {path: path.read_bytes() for path in files}
    found = {path: list(places(ast.parse(source))) for path, source in sources.items()}
    mutants = []
    for path in rng.choices(files, weights=[len(found[path]) for path in files], k=count):
        node = rng.choice(found[path])
        old, new = changed(node, rng.choice((-1, 1))) or (None, "")
        assert old is not None
        source, name = sources[path], path.relative_to(ROOT).as_posix()
        start, end = span_of(source, old)
        new_text = f"({new}{chr(10) * source[start:end].count(bytes([10]))})".encode()
        mutant = source[:start] + new_text + source[end:]
        words = f"{ast.unparse(old)}  ->  {new}"
        mutants.append(Mutant(name, old.lineno, (start, end), words, mutant))
    return mutants


def probed(source: bytes, probes: dict[tuple[int, int], int]) -> bytes:
    """Return a source in which each of some places logs its number when it is reached."""
    inserted = [(start, 1, -end, f"__probed__({n}, ") for (start, end), n in probes.items()]
    inserted += [(end, 0, -start, ")") for start, end in probes]
    for place, _, _, text in sorted(inserted, reverse=True):
        source = source[:place] + text.encode() + source[place:]
    return source


# -- running tests in forks


class TimedTest(NamedTuple):
    """A test, its seconds of processor time, and whether it is marked slow."""

    name: str
    seconds: float
    slow: bool

    @property
    def file(self) -> str:
        return self.name.partition("::")[0]


class OnlyFiles:
    """A plugin of pytest that runs the tests named, file by file in this order, and notes which fail."""

    def __init__(self, tests: Sequence[TimedTest]) -> None:
        self.order = {test.name: place for place, test in enumerate(tests)}
        self.files: dict[str, int] = {}
        for place, test in enumerate(tests):
            self.files.setdefault(test.file, place)
        self.failed: list[str] = []

    @pytest.hookimpl(tryfirst=True)
    def pytest_collection_modifyitems(self, items: list[pytest.Item]) -> None:
        def place(item: pytest.Item) -> tuple[int, int]:
            return self.files[item.nodeid.partition("::")[0]], self.order[item.nodeid]

        items[:] = sorted((item for item in items if item.nodeid in self.order), key=place)

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        if report.failed:
            self.failed.append(report.nodeid)

    def pytest_collectreport(self, report: pytest.CollectReport) -> None:
        if report.failed:
            self.failed.append(f"import of {report.nodeid}")


class Timed:
    """A plugin of pytest that records the time of each test, and writes its name to the log of the probes."""

    def __init__(self, log: Path) -> None:
        self.log = log
        self.tests: list[TimedTest] = []

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_protocol(self, item: pytest.Item) -> Iterator[None]:
        __probed__.__defaults__[0].clear()  # type: ignore[name-defined]  # noqa: F821
        with self.log.open("a", encoding="utf-8") as file:
            file.write(f"test {item.nodeid}\n")
        start = computing()
        result = yield
        slow = item.get_closest_marker("slow") is not None
        self.tests.append(TimedTest(item.nodeid, round(computing() - start, 3), slow))
        return result


def computing() -> float:
    """Return the processor time of this process and of the children that it waited for, in seconds."""
    return sum(os.times()[:4])


def forked(work: Callable[[], object], seconds: float, output: Path) -> int:
    """Do work in a fork with a limit of processor time, its output in a file; return the process id."""
    child = os.fork()
    if child:
        return child
    try:
        os.setsid()
        resource.setrlimit(resource.RLIMIT_CPU, (int(seconds), int(seconds)))
        resource.setrlimit(resource.RLIMIT_DATA, (MAX_BYTES, MAX_BYTES))
        with output.open("wb") as log:
            os.dup2(log.fileno(), 1)
            os.dup2(log.fileno(), 2)
        work()
    except BaseException:
        traceback.print_exc()
    finally:
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(0)


def ended(child: int, since: float, seconds: float) -> bool:
    """Return whether a fork has ended; after too long a time, kill it and all its children."""
    done = os.waitpid(child, os.WNOHANG)[0]
    if done or time.monotonic() - since > 8 * seconds:
        with contextlib.suppress(ProcessLookupError):
            os.killpg(child, signal.SIGKILL)
        if not done:
            os.waitpid(child, 0)
        return True
    return False


def pytest_here(copy: Path, words: Iterable[str], *plugins: object) -> int:
    """Run pytest in this process in a copy of the project."""
    os.chdir(copy)
    sys.path.insert(0, str(copy))
    options = ["-q", "-n0", "-p", "no:cacheprovider", OPTIONS]
    return int(pytest.main([*options, *words], plugins=plugins))


def failures(copy: Path, tests: Sequence[TimedTest], *options: str) -> list[str]:
    """Return the tests that fail in a copy of the project; one that does not end has failed."""
    if not tests:
        return []
    seconds = SPARE_SECONDS + 5 * sum(test.seconds for test in tests)
    note = copy.parent / "failed.json"
    note.write_text('["no end"]')

    def work() -> None:
        plugin = OnlyFiles(tests)
        status = pytest_here(copy, [*options, *sorted({test.file for test in tests})], plugin)
        failed = plugin.failed or ([] if status in (0, 5) else [f"status {status}"])  # 5: no tests
        note.write_text(json.dumps(failed), encoding="utf-8")

    child, since = forked(work, seconds, copy.parent / "log"), time.monotonic()
    while not ended(child, since, seconds):
        time.sleep(0.05)
    return list(json.loads(note.read_text(encoding="utf-8")))


def copied(folder: Path) -> Path:
    """Copy the project to a folder, make all processes import the copy, and return its path."""
    for name in PRELOADED:
        importlib.import_module(name)
    copy = folder / "project"
    skip = shutil.ignore_patterns("__pycache__", "build", "site", ".mypy_cache")
    shutil.copytree(ROOT, copy, ignore=skip, symlinks=True)
    (folder / "probe").mkdir()
    (folder / "probe" / "sitecustomize.py").write_text(PROBE, encoding="utf-8")
    os.environ |= {
        "PYTHONPATH": f"{copy}{os.pathsep}{folder / 'probe'}",
        "NUMBA_CACHE_DIR": str(folder / "cache"),
        "PYTHONDONTWRITEBYTECODE": "1",
    }
    sys.dont_write_bytecode = True
    return copy


# -- which tests reach which mutant


def reach(seeds: Sequence[int], count: int, processes: int) -> None:
    """Run all tests, each file in its own process; record their times and the probes that they reach."""
    mutants = [mutant for seed in seeds for mutant in draw(count, seed)]
    number = {mutant.place: n for n, mutant in enumerate(mutants)}
    probes: dict[str, dict[tuple[int, int], int]] = defaultdict(dict)
    for mutant in mutants:
        if not mutant.compiled:
            probes[mutant.file][mutant.span] = number[mutant.place]
    with tempfile.TemporaryDirectory() as folder:
        copy = copied(Path(folder))
        for file, places_of_file in probes.items():
            (copy / file).write_bytes(probed((copy / file).read_bytes(), places_of_file))
        exec(PROBE, {})
        tests, reached = all_tests(copy, test_files(copy), processes)
    places_reached: dict[str, list[str]] = defaultdict(list)
    for test, numbers in reached.items():
        for n in numbers:
            places_reached[mutants[n].place].append(test)
    REACH.parent.mkdir(exist_ok=True)
    REACH.write_text(json.dumps({"tests": tests, "reached": places_reached}), encoding="utf-8")


def test_files(copy: Path) -> list[list[str]]:
    """Return the pytest arguments of each process: a file of tests, or a package or folder of examples."""
    tests = [[path.relative_to(copy).as_posix()] for path in sorted((copy / "tests").rglob("*.py"))
             if path.name.startswith("test_") or path.name == "conformance.py"]  # fmt: skip
    examples = [["README.md"], ["docs"], ["tests/subcases.py"], ["rotation"], ["anim"]]
    parts = sorted(path for path in (copy / "hfield").iterdir() if path.suffix in (".py", ""))
    inside = [[path.relative_to(copy).as_posix()] for path in parts if path.name != "py.typed"]
    return tests + examples + [words for words in inside if "__pycache__" not in words[0]]


def all_tests(
    copy: Path, files: list[list[str]], processes: int
) -> tuple[list[TimedTest], dict[str, set[int]]]:
    """Run the tests; return them, and the probes that each reaches, including those at import of its file."""
    tests: list[TimedTest] = []
    reached: dict[str, set[int]] = {}
    todo = dict(enumerate(files))
    running: dict[int, tuple[int, float]] = {}
    seconds = 900

    def work(n: int, log: Path) -> None:
        os.environ["PROBE_LOG"] = str(log)
        __probed__.__defaults__ = (set(), str(log))  # type: ignore[name-defined]  # noqa: F821
        log.touch()
        plugin = Timed(log)
        pytest_here(copy, ["--runslow", *files[n]], plugin)
        log.with_suffix(".json").write_text(json.dumps(plugin.tests), encoding="utf-8")

    while todo or running:
        while todo and len(running) < processes:
            n = next(iter(todo))
            del todo[n]
            log = copy.parent / f"{n}.probes"
            child = forked(lambda n=n, log=log: work(n, log), seconds, copy.parent / f"{n}.log")  # type: ignore[misc]
            running[child] = n, time.monotonic()
        time.sleep(0.05)
        for child, (n, since) in list(running.items()):
            if ended(child, since, seconds):
                del running[child]
                noted = copy.parent / f"{n}.json"
                if not noted.exists():
                    print(files[n], "did not end", flush=True)
                    continue
                found = [TimedTest(*test) for test in json.loads(noted.read_text(encoding="utf-8"))]
                print(files[n], len(found), round(sum(t.seconds for t in found), 1), flush=True)
                tests += found
                reached |= read_probes(copy.parent / f"{n}.probes", found)
    return tests, reached


def read_probes(log: Path, tests: Iterable[TimedTest]) -> dict[str, set[int]]:
    """Return the probes that each test of a file reaches; those reached at import count for every test."""
    at_import: set[int] = set()
    met = at_import
    by_test: dict[str, set[int]] = {test.name: set() for test in tests}
    for line in log.read_text(encoding="utf-8").splitlines():
        if line.startswith("test "):
            met = by_test.setdefault(line[5:], set())
        else:
            met.add(int(line))
    for numbers in by_test.values():
        numbers |= at_import
    return by_test


# -- trying mutants


def run(count: int, seed: int, output: Path) -> None:
    """Try ``count`` mutants; after each, write which suite noticed it, and by which test.

    Mutants that are already in the output are skipped.
    """
    noted = json.loads(REACH.read_text(encoding="utf-8"))
    timed = [TimedTest(*test) for test in noted["tests"]]
    tests = {test.name: test for test in timed if not needs_browser(test.file)}
    done: list[dict[str, object]] = []
    if output.exists():
        done = json.loads(output.read_text(encoding="utf-8"))
    passing: set[str] = set()
    failing: set[str] = set()  # without a mutant too
    with tempfile.TemporaryDirectory() as folder:
        copy = copied(Path(folder))
        compile_tests(copy)
        for mutant in draw(count, seed)[len(done) :]:
            found = tests_of(mutant, list(tests.values()), noted["reached"].get(mutant.place, []))
            while True:
                result = try_mutant(copy, mutant, [t for t in found if t.name not in failing])
                name = str(result["full"])
                if name not in tests or name in passing:
                    break
                (failing if failures(copy, [tests[name]], "--runslow") else passing).add(name)
            done.append(result)
            output.write_text(json.dumps(done, indent=1, ensure_ascii=False), encoding="utf-8")
            print(len(done), result, flush=True)
    quick, full = (sum(bool(m[name]) for m in done) for name in ("quick", "full"))
    print(f"of {len(done)} mutants the quick suite notices {quick}, the full one {full}")


def needs_browser(file: str) -> bool:
    """Return whether tests draw in Chromium, which may wait for ever in a fork with limited memory."""
    return file.endswith(".py") and "tests.anim.chromium" in (ROOT / file).read_text(
        encoding="utf-8"
    )


def compile_tests(copy: Path) -> None:
    """Let pytest cache the tests with rewritten assertions, since rewriting is slow."""

    def work() -> None:
        sys.dont_write_bytecode = False
        pytest_here(copy, ["--collect-only", "tests"])

    child = forked(work, 300, copy.parent / "log")
    os.waitpid(child, 0)


def try_mutant(copy: Path, mutant: Mutant, tests: list[TimedTest]) -> dict[str, object]:
    """Try one mutant in the copy."""
    file, start = copy / mutant.file, computing()
    before = file.read_bytes()
    file.write_bytes(mutant.source)
    quick_tests = within([test for test in tests if not test.slow], QUICK_SECONDS)
    by_function: dict[str, TimedTest] = {}
    for test in quick_tests:
        by_function.setdefault(test.name.partition("[")[0], test)
    first = list(by_function.values())[:FIRST_TESTS]
    rest = [test for test in quick_tests if test not in first]
    quick = (failures(copy, first, "-x") or failures(copy, rest, "-x") or [None])[0]
    slow_tests = within([test for test in tests if test.slow], SLOW_SECONDS)
    all_tests = [*slow_tests, *quick_tests]  # with --runslow quick tests draw more cases
    full = quick or (failures(copy, all_tests, "-x", "--runslow") or [None])[0]
    file.write_bytes(before)
    place = {"file": mutant.file, "line": mutant.line, "change": mutant.change}
    counts = {"tests": len(tests), "slow tests": len(slow_tests)}
    return place | counts | {"quick": quick, "full": full, "seconds": round(computing() - start, 1)}


def tests_of(mutant: Mutant, tests: list[TimedTest], reaching: list[str]) -> list[TimedTest]:
    """Return the tests that try a mutant: those that reach it, then the others of their files.

    The others are needed because a test may use a cached result of the changed line. In both groups the
    tests in the folder named like that of the mutant are first, and fast tests precede slow ones.
    """
    package, part = mutant.file.split("/")[:2]
    folder = f"tests/{part if package == 'hfield' else package}/"
    if mutant.compiled:
        found = [test for test in tests if test.name.startswith(folder)] or tests
        return sorted(found, key=lambda test: test.seconds)
    names = set(reaching)
    files = {name.partition("::")[0] for name in reaching}
    found = [test for test in tests if test.file in files]
    return sorted(
        found,
        key=lambda test: (
            test.name not in names,
            not test.name.startswith(folder),
            test.seconds,
        ),
    )


def within(tests: Iterable[TimedTest], seconds: float) -> list[TimedTest]:
    """Return the longest initial part of the tests that takes at most ``seconds`` in all."""
    found = []
    for test in tests:
        seconds -= test.seconds
        if seconds < 0:
            break
        found.append(test)
    return found


def main() -> None:
    """Read the command line."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter
    )
    commands = parser.add_subparsers(dest="command", required=True)
    reaching = commands.add_parser("reach")
    reaching.add_argument("--seeds", type=int, nargs="+", required=True)
    reaching.add_argument("--processes", type=int, default=2)
    trying = commands.add_parser("run")
    trying.add_argument("--seed", type=int, required=True)
    trying.add_argument("-o", "--output", type=Path, required=True)
    for command in (reaching, trying):
        command.add_argument("--count", type=int, default=150)
    words = parser.parse_args()
    if words.command == "reach":
        reach(words.seeds, words.count, words.processes)
    else:
        run(words.count, words.seed, words.output)


if __name__ == "__main__":
    main()
