"""The checker stands alone: it imports the standard library and itself, and runs from a copy."""

import ast
import json
import shutil
import subprocess
import sys
from pathlib import Path

import hfield.checker
from tests.checker.cases import decided

FOLDER = Path(hfield.checker.__file__).parent
FILES = sorted(FOLDER.rglob("*.py"))


def imported(path: Path) -> set[str]:
    found = set()
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            found |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            found.add(node.module or "")
        elif isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
            assert node.func.id not in ("eval", "exec", "compile", "__import__"), path
    return found


def test_it_imports_nothing_else() -> None:
    assert len(FILES) > 10
    for path in FILES:
        for module in imported(path):
            own = f"{module}.".startswith("hfield.checker.")
            assert own or module.split(".")[0] in sys.stdlib_module_names, (path.name, module)


def test_it_runs_without_the_rest_of_the_package(tmp_path: Path) -> None:
    copy = tmp_path / "hfield" / "checker"
    shutil.copytree(FOLDER, copy, ignore=shutil.ignore_patterns("__pycache__"))
    (tmp_path / "hfield" / "__init__.py").write_text("")
    data = [decided("p*q == 0 => p == 0 or q == 0", "QQ"), decided("p*q == q*p", "GF(9)")]
    (tmp_path / "data.json").write_text(json.dumps(data))
    program = (
        "import json, sys; from hfield.checker.check import check\n"
        "print([check(c).verdict for c in json.load(open('data.json'))])\n"
        "print([m for m in ('flint', 'sympy', 'numpy', 'galois', 'hfield.syntax') if m in sys.modules])"
    )
    done = subprocess.run(
        [sys.executable, "-S", "-c", program],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        check=True,
        env={"PYTHONPATH": str(tmp_path)},
    )
    assert done.stdout.split("\n")[:2] == ["['proved', 'refuted']", "[]"]
