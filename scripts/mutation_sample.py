"""Measure what share of random faults the quick and the full test suite notice.

    pip install coverage
    python scripts/mutation_sample.py contexts      # about 30 minutes: which test reaches which line
    python scripts/mutation_sample.py run --seed 1 --count 150 -o first.json

A mutant is one of the three packages with one operator, comparison, constant or condition changed at a
place drawn by the seed. It is tried by the tests that reach the changed line, the quickest first: the
quick suite, and where that notices nothing the slow tests too. docs/mutation.md has the scores.
"""

import argparse
import ast
import json
import os
import random
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).parents[1]
PACKAGES = ("hfield", "rotation", "anim")
DATA = ROOT / "build" / "contexts" / ".coverage"
COMPARISONS = {
    ast.Lt: ast.LtE, ast.LtE: ast.Lt, ast.Gt: ast.GtE, ast.GtE: ast.Gt, ast.Eq: ast.NotEq,
    ast.NotEq: ast.Eq, ast.In: ast.NotIn, ast.NotIn: ast.In, ast.Is: ast.IsNot, ast.IsNot: ast.Is,
}  # fmt: skip
OPERATORS = {
    ast.Add: ast.Sub, ast.Sub: ast.Add, ast.Mult: ast.Add, ast.Div: ast.Mult,
    ast.FloorDiv: ast.Mult, ast.Mod: ast.FloorDiv, ast.Pow: ast.Mult, ast.LShift: ast.RShift,
    ast.RShift: ast.LShift, ast.BitAnd: ast.BitOr, ast.BitOr: ast.BitAnd, ast.BitXor: ast.BitAnd,
}  # fmt: skip
SECONDS = 300  # for the tests of one mutant; a mutant that takes longer counts as noticed


def is_typing(node: ast.AST) -> bool:
    return isinstance(node, ast.If) and ast.unparse(node.test) == "TYPE_CHECKING"


def places(tree: ast.Module) -> Iterator[ast.AST]:
    """Yield the nodes inside functions that a mutant may change: no annotations, messages or decorators."""
    todo: list[tuple[ast.AST, bool]] = [(tree, False)]
    while todo:
        node, inside = todo.pop()
        if is_typing(node) or isinstance(node, (ast.Raise, ast.JoinedStr, ast.Assert)):
            continue
        if inside and mutations(node):
            yield node
        for name, value in ast.iter_fields(node):
            if name in ("annotation", "returns", "decorator_list", "ops"):
                continue
            function = inside or isinstance(node, (ast.FunctionDef, ast.Lambda))
            children = value if isinstance(value, list) else [value]
            todo += [(child, function) for child in children if isinstance(child, ast.AST)]


def mutations(node: ast.AST) -> list[str]:
    """Return which changes can be made at a node."""
    match node:
        case ast.Compare(ops=[op]) if type(op) in COMPARISONS:
            return ["comparison"]
        case ast.BinOp(op=op) if type(op) in OPERATORS:
            return ["operator"]
        case ast.BoolOp():
            return ["and or or"]
        case ast.UnaryOp(op=ast.Not() | ast.USub()):
            return ["sign or negation dropped"]
        case ast.Constant(value=bool()):
            return ["truth value"]
        case ast.Constant(value=int()):
            return ["number"]
        case ast.If() | ast.IfExp() | ast.While():
            return ["condition"]
    return []


def change(node: ast.AST, rng: random.Random) -> str:
    """Change a node in place and return in words what was done."""
    before = ast.unparse(node).split("\n")[0]
    match node:
        case ast.Compare(ops=[op]):
            node.ops = [COMPARISONS[type(op)]()]
        case ast.BinOp(op=op):
            node.op = OPERATORS[type(op)]()
        case ast.BoolOp(op=op):
            node.op = ast.Or() if isinstance(op, ast.And) else ast.And()
        case ast.UnaryOp(op=ast.Not(), operand=operand):
            node.op, node.operand = ast.Not(), ast.UnaryOp(ast.Not(), operand)
        case ast.UnaryOp(op=ast.USub()):
            node.op = ast.UAdd()
        case ast.Constant(value=bool(value)):
            node.value = not value
        case ast.Constant(value=int(value)):
            node.value = value + rng.choice((-1, 1))
        case ast.If(test=test) | ast.IfExp(test=test) | ast.While(test=test):
            node.test = ast.UnaryOp(ast.Not(), test)
    return f"{before}  ->  {ast.unparse(node).splitlines()[0]}"


def draw(count: int, seed: int) -> list[dict[str, object]]:
    """Return so many mutants: file, line, what is changed, and the changed source."""
    rng = random.Random(seed)
    files = [path for package in PACKAGES for path in sorted((ROOT / package).rglob("*.py"))]
    found: dict[Path, int] = {}
    for path in files:
        found[path] = sum(1 for _ in places(ast.parse(path.read_text(encoding="utf-8"))))
    mutants: list[dict[str, object]] = []
    for path in rng.choices(list(found), weights=list(found.values()), k=count):
        tree = ast.parse(path.read_text(encoding="utf-8"))
        node = rng.choice(list(places(tree)))
        words = change(node, rng)
        name = path.relative_to(ROOT).as_posix()
        source = ast.unparse(ast.fix_missing_locations(tree))
        mutants.append({"file": name, "line": node.lineno, "change": words, "source": source})  # type: ignore[attr-defined]
    return mutants


def contexts() -> None:
    """Run all tests once under coverage, which notes for each line the tests that run it."""
    shutil.rmtree(DATA.parent, ignore_errors=True)
    DATA.parent.mkdir(parents=True)
    settings = DATA.with_name("settings")
    settings.write_text(
        f"[run]\nsource = {','.join(PACKAGES)}\ndynamic_context = test_function\n"
        f"data_file = {DATA}\nparallel = true\n"
    )
    tests = [sys.executable, "-m", "coverage", "run", f"--rcfile={settings}", "-m", "pytest"]
    first = [
        "tests/rings",
        "tests/anim",
        "tests/rotation",
        "tests/structure",
        "tests/conformance.py",
    ]
    rest = ["tests", *(f"--ignore={name}" for name in first)]
    running = [
        subprocess.Popen([*tests, "-n0", "--runslow", *half], cwd=ROOT) for half in (first, rest)
    ]
    for process in running:
        process.wait()
    subprocess.run(
        [sys.executable, "-m", "coverage", "combine", f"--rcfile={settings}"], check=True
    )


def reaching(file: str, line: int) -> list[str]:
    """Return the tests that run a line, as pytest names them."""
    from coverage import CoverageData

    data = CoverageData(str(DATA))
    data.read()
    paths = [name for name in data.measured_files() if name.endswith("/" + file)]
    names = [name for path in paths for name in data.contexts_by_lineno(path).get(line, [])]
    return sorted({node for name in names if (node := node_of(name))})


def node_of(context: str) -> str | None:
    """Return pytest's name of a test function that coverage names with dots."""
    parts = context.split("|")[0].split(".")
    for n in range(len(parts) - 1, 0, -1):
        path = Path(*parts[:n]).with_suffix(".py")
        if (ROOT / path).is_file():
            return "::".join([path.as_posix(), *parts[n:]])
    return None


def notices(copy: Path, tests: list[str], *options: str) -> bool:
    """Whether a suite fails in a copy of the project; the tests stop at the first failure."""
    if not tests:
        return False
    command = [
        sys.executable,
        "-m",
        "pytest",
        "-x",
        "-q",
        "-n0",
        "-p",
        "no:cacheprovider",
        *options,
    ]
    environment = os.environ | {"PYTHONPATH": str(copy), "PYTHONDONTWRITEBYTECODE": "1"}
    try:
        done = subprocess.run(
            [*command, *tests], cwd=copy, env=environment, capture_output=True, timeout=SECONDS
        )
    except subprocess.TimeoutExpired:
        return True
    return done.returncode not in (0, 5)  # 5: no test of this kind


def run(count: int, seed: int, output: Path) -> None:
    """Try so many mutants and write after each which suite noticed it."""
    done: list[dict[str, object]] = []
    with tempfile.TemporaryDirectory() as folder:
        copy = Path(folder) / "project"
        skip = shutil.ignore_patterns(".git", "__pycache__", "build", "_build", "site")
        shutil.copytree(ROOT, copy, ignore=skip)
        for mutant in draw(count, seed):
            file = copy / str(mutant["file"])
            before = file.read_text(encoding="utf-8")
            file.write_text(str(mutant.pop("source")), encoding="utf-8")
            tests = reaching(str(mutant["file"]), int(str(mutant["line"])))
            quick = notices(copy, tests)
            full = quick or notices(copy, tests, "--runslow", "-m", "slow")
            file.write_text(before, encoding="utf-8")
            done.append(mutant | {"tests": len(tests), "quick": quick, "full": full})
            output.write_text(json.dumps(done, indent=1, ensure_ascii=False), encoding="utf-8")
    quick, full = (sum(bool(m[name]) for m in done) for name in ("quick", "full"))
    print(f"of {len(done)} mutants the quick suite notices {quick}, the full one {full}")


def main() -> None:
    """Read the command line."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter
    )
    commands = parser.add_subparsers(dest="command", required=True)
    commands.add_parser("contexts")
    trying = commands.add_parser("run")
    trying.add_argument("--seed", type=int, required=True)
    trying.add_argument("--count", type=int, default=150)
    trying.add_argument("-o", "--output", type=Path, required=True)
    words = parser.parse_args()
    if words.command == "contexts":
        contexts()
    else:
        run(words.count, words.seed, words.output)


if __name__ == "__main__":
    main()
