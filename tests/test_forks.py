"""A child of a fork waits for no import that a thread of its parent had begun."""

import ast
import os
import subprocess
import sys
from collections import defaultdict
from collections.abc import Iterable, Iterator
from pathlib import Path

import pytest

from tests.patience import PATIENCE

ROOT = Path(__file__).parents[1]
PACKAGES = ("hfield", "rotation", "anim")
COMPILING = ("hfield/compiling", "rotation/kernels", "rotation/native")

needs_fork = pytest.mark.skipif(not hasattr(os, "fork"), reason="this system has no fork")

WATCH = """
import os, sys, threading, time

def watch(children):
    "Print how each child ended; one that still runs after ten minutes hangs."
    for child in children:
        for _ in range(12_000):
            pid, status = os.waitpid(child, os.WNOHANG)
            if pid:
                print("ended", status)
                break
            time.sleep(0.05)
        else:
            os.kill(child, 9)
            print("hangs")
    sys.stdout.flush()
    os._exit(0)
"""

# The first call imports and compiles; children are forked from its beginning to its end and make it too.
FIRST_CALL = """
import numpy as np
{import_}

def first():
    {call}

thread = threading.Thread(target=first)
thread.start()
children = []
for _ in range(4):
    child = os.fork()
    if not child:
        first()
        os._exit(0)
    children.append(child)
    time.sleep(0.01)
watch(children)
"""

# The import of the probe ends only in a child, and those of its modules only before it.
BEGUN_IMPORT = """
import hfield
begun = sys.begun = threading.Event()
sys.parent = os.getpid()
threading.Thread(target=lambda: __import__("probe.heavy"), daemon=True).start()
begun.wait()
child = os.fork()
if not child:
    from probe import heavy
    from probe.registry import entries
    os._exit(entries != ["heavy"])
watch([child])
"""


def run(code: str, **environment: str) -> str:
    done = subprocess.run(
        [sys.executable, "-W", "ignore", "-c", WATCH + code],
        capture_output=True,
        text=True,
        check=False,
        timeout=PATIENCE,
        env={**os.environ, **environment},
    )
    return done.stdout + done.stderr


@pytest.mark.slow
@needs_fork
@pytest.mark.parametrize(
    ("import_", "call"),
    [
        ("import rotation", "rotation.rotate(*(np.ones((700, n)).squeeze() for n in (3, 3, 1)))"),
        (
            "from rotation import rotate",
            "rotate(*(np.ones((700, n)).squeeze() for n in (3, 3, 1)))",
        ),
        ("from hfield import ring", "ring('RR')('sqrt(2)+pi')"),
    ],
)
def test_children_forked_during_the_first_call(import_: str, call: str, tmp_path: Path) -> None:
    code = FIRST_CALL.format(import_=import_, call=call)
    assert run(code, NUMBA_CACHE_DIR=str(tmp_path)) == "ended 0\n" * 4


@needs_fork
def test_a_child_imports_what_another_thread_was_importing(tmp_path: Path) -> None:
    probe = tmp_path / "probe"
    probe.mkdir()
    (probe / "__init__.py").write_text("import probe.heavy")
    (probe / "registry.py").write_text("entries = []")
    (probe / "heavy.py").write_text(
        "import os, sys, time\n"
        "from probe.registry import entries\n"
        "entries.append('heavy')\n"
        "sys.begun.set()\n"
        "while os.getpid() == sys.parent: time.sleep(1)\n"
    )
    assert run(BEGUN_IMPORT, PYTHONPATH=str(tmp_path)) == "ended 0\n"


def test_every_package_begins_with_the_module_that_knows_of_forks() -> None:
    for package in PACKAGES:
        body = ast.parse((ROOT / package / "__init__.py").read_text(encoding="utf-8")).body
        names = [
            alias.name for node in body if isinstance(node, ast.Import) for alias in node.names
        ]
        assert "hfield.core.locks" in names


def unlocked(tree: ast.AST) -> Iterator[tuple[str, ast.AST]]:
    """Yield what functions do outside of ``with …lock:``, with the names of the functions."""

    def walk(node: ast.AST, function: str) -> Iterator[tuple[str, ast.AST]]:
        for child in ast.iter_child_nodes(node):
            if isinstance(child, ast.With) and any(
                ast.unparse(item.context_expr).endswith("lock") for item in child.items
            ):
                continue
            yield function, child
            yield from walk(child, child.name if isinstance(child, ast.FunctionDef) else function)

    yield from walk(tree, "")


def called(nodes: Iterable[ast.AST]) -> set[str]:
    """Return the names of the functions that are called."""
    calls = (node.func for node in nodes if isinstance(node, ast.Call))
    return {function.id for function in calls if isinstance(function, ast.Name)}


def imports_outside_the_lock(source: str) -> set[str]:
    """Return the functions that import without the lock; a helper may, if its callers hold the lock."""
    found = defaultdict[str, list[ast.AST]](list)
    for function, node in unlocked(ast.parse(source)):
        found[function].append(node)
    imports = {
        f
        for f, nodes in found.items()
        if f and any(isinstance(node, ast.Import | ast.ImportFrom) for node in nodes)
    }
    bodies = {f: called(nodes) for f, nodes in found.items()}
    while callers := {f for f, names in bodies.items() if names & imports} - imports:
        imports |= callers
    return imports - called(ast.walk(ast.parse(source)))


def test_what_compiles_imports_under_the_lock_alone() -> None:
    sources = [path for package in COMPILING for path in (ROOT / package).rglob("*.py")]
    assert len(sources) > 15
    for path in sources:
        assert not imports_outside_the_lock(path.read_text(encoding="utf-8")), path


def test_an_import_outside_the_lock_is_found() -> None:
    faulty = "def f():\n    import a\n    with lock:\n        g()\ndef g():\n    import b\n"
    assert imports_outside_the_lock(faulty) == {"f"}
    assert imports_outside_the_lock("def f():\n    g()\ndef g():\n    import b\n") == {"f"}
