"""Options, fixtures and helpers of all tests."""

import doctest
import gc
import os
import signal
import sys
import types
from contextlib import suppress
from pathlib import Path

import hypothesis
import pytest

from tests import thorough

QUICK_EXAMPLES, EXAMPLES = 15, 50  # that hypothesis draws where a test does not say how many

os.environ.pop("PYTHONDONTWRITEBYTECODE", None)  # a hundred commands are started: compiled once

PAGE = Path(__file__).parents[1] / "docs" / "reference" / "rings.md"


def pytest_addoption(parser: pytest.Parser) -> None:
    """Add ``--runslow``, and ``--once`` for other dependencies, which seldom break one case alone."""
    parser.addoption("--runslow", action="store_true", help="run the tests marked slow too")
    parser.addoption("--once", action="store_true", help="run the first case of each test only")


def pytest_configure(config: pytest.Config) -> None:
    """Give tests what a plain command has: no width of lines, which pytest's workers set, and Ctrl-C.

    While modules are imported nothing is garbage, and looking for it takes a third of the time.

    Under a shell's ``&`` Ctrl-C is ignored, by the commands that tests start too. Hypothesis has no
    deadline, since a busy machine is slow and not wrong.
    """
    gc.disable()
    thorough.run_all = config.getoption("runslow")
    drawn = EXAMPLES if thorough.run_all else QUICK_EXAMPLES
    hypothesis.settings.register_profile("any machine", deadline=None, max_examples=drawn)
    hypothesis.settings.load_profile("any machine")
    os.environ.pop("COLUMNS", None)
    if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
        with suppress(ValueError):  # not in the main thread
            signal.signal(signal.SIGINT, signal.default_int_handler)


class LastFirst:
    """Collects the last files of a folder first."""

    def collect(self):
        """Return the files and folders."""
        return reversed(list(super().collect()))


class LastFirstPackage(LastFirst, pytest.Package):
    """A folder with an ``__init__.py``."""


class LastFirstDir(LastFirst, pytest.Dir):
    """A folder without one."""


def pytest_collect_directory(path: Path, parent: pytest.Collector) -> pytest.Collector | None:
    """Let every other worker begin at the end.

    All workers collect all files at the same time. From a clean checkout each compiles half of them, and
    reads the other half as others have compiled it.
    """
    worker = getattr(parent.config, "workerinput", {"workerid": "gw0"})["workerid"]
    if int(worker[2:]) % 2 == 0:
        return None
    kind = LastFirstPackage if (path / "__init__.py").is_file() else LastFirstDir
    return kind.from_parent(parent, path=path)


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Leave out slow tests, unless they are asked for, and all cases but the first under ``--once``.

    Workers must agree on the order. Files with slow tests come first, or one worker would end with a long
    test while the others are done.
    """
    if config.getoption("once"):
        items[:] = {item.nodeid.partition("[")[0]: item for item in reversed(items)}.values()
        items.reverse()
    if not (config.getoption("runslow") or config.getoption("markexpr")):
        config.hook.pytest_deselected(items=[i for i in items if i.get_closest_marker("slow")])
        items[:] = [item for item in items if not item.get_closest_marker("slow")]
    if hasattr(config, "workerinput"):
        slow = {item.path for item in items if item.get_closest_marker("slow")}
        items.sort(key=lambda item: (item.path not in slow, item.path))


def pytest_collection_finish() -> None:
    """Keep what collecting has made out of the sight of the garbage collector, which looks seldom then.

    What thousands of tests leave in caches is much to look through, and little of it is garbage.
    """
    gc.enable()
    gc.collect()
    gc.freeze()
    gc.set_threshold(20_000, 20, 20)


@pytest.hookimpl(optionalhook=True)  # of pytest-xdist
def pytest_xdist_make_scheduler(config: pytest.Config, log: object) -> object:
    """Give each worker a run of neighbouring tests, which share caches; who is done takes from others."""
    from xdist.scheduler import WorkStealingScheduling

    return WorkStealingScheduling(config, log) if config.option.dist == "load" else None


@pytest.fixture(scope="module")
def dual_numbers():
    """The class of rings that docs/reference/rings.md builds from scratch, a ring of a user's own."""
    page = types.ModuleType("rings_page")  # a module, so that its classes can be pickled
    sys.modules[page.__name__] = page
    for example in doctest.DocTestParser().get_examples(PAGE.read_text(encoding="utf-8")):
        if example.source.startswith(("from ", "@dataclass", "class ")):
            exec(example.source, vars(page))
    yield page.DualNumbers
    del sys.modules[page.__name__]
