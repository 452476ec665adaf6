"""Which module needs which: imports as written, imports by string, and names that packages hand on.

A string counts as an import where it is an argument of ``import_module``, or names something that a module of
the same package defines, from some package above on: ``"rationals.arithmetic.RationalArithmetic"``.
"""

import ast
import re
from collections.abc import Iterable, Iterator, Mapping
from functools import cache
from pathlib import Path

ROOT = Path(__file__).parent.parent
PACKAGES = ("hfield", "rotation", "anim")
DOTTED = re.compile(r"[A-Za-z_]\w*(\.\w+)+")

Sources = Mapping[str, str]
Graph = dict[str, set[str]]


@cache
def sources() -> list[tuple[str, str]]:
    """Every module of the three packages with its text."""
    out = []
    for package in PACKAGES:
        for path in sorted((ROOT / package).rglob("*.py")):
            parts = path.relative_to(ROOT).with_suffix("").parts
            module = ".".join(parts[:-1] if parts[-1] == "__init__" else parts)
            out.append((module, path.read_text(encoding="utf-8")))
    return out


@cache
def stubs() -> dict[str, str]:
    """Every package whose names are said in a stub and imported on first use, with the stub."""
    found = {}
    for package in PACKAGES:
        for path in sorted((ROOT / package).rglob("__init__.pyi")):
            name = ".".join(path.parent.relative_to(ROOT).parts)
            found[name] = path.read_text(encoding="utf-8")
    return found


def running(node: ast.AST) -> Iterator[ast.AST]:
    """The nodes that may run: all but those under ``if TYPE_CHECKING``, which name types."""
    yield node
    for child in children(node):
        yield from running(child)


def children(node: ast.AST) -> Iterable[ast.AST]:
    """The nodes below one that may run, one level down."""
    typing = isinstance(node, ast.If) and ast.unparse(node.test) == "TYPE_CHECKING"
    return node.orelse if typing else ast.iter_child_nodes(node)


def graph(modules: Sources, stubs: Mapping[str, str] = {}) -> Graph:
    """Return which modules each one needs when it runs."""
    trees = {module: ast.parse(text) for module, text in modules.items()}
    handed = {package: _handed_on(package, text) for package, text in stubs.items()}
    defined = {module: _defined(tree) for module, tree in trees.items()}
    by_name = _by_suffix(defined)
    found: Graph = {module: set() for module in modules}
    for module, tree in trees.items():
        for node in running(tree):
            found[module] |= set(_imports(node, found, handed))
            found[module] |= set(_by_string(node, module, defined, by_name))
        found[module].discard(module)
    return found


def _imports(node: ast.AST, modules: Graph, handed: dict[str, dict[str, str]]) -> Iterator[str]:
    """Yield the modules that an import statement names; a re-exported name leads to its module."""
    if isinstance(node, ast.Import):
        yield from (alias.name for alias in node.names if alias.name in modules)
    elif isinstance(node, ast.ImportFrom):
        above = node.module or ""
        for alias in node.names:
            inside = f"{above}.{alias.name}"
            if inside in modules:
                yield inside
                continue
            if above in modules:
                yield above
            source = handed.get(above, {}).get(alias.name)
            if source in modules:
                yield source


def _handed_on(package: str, stub: str) -> dict[str, str]:
    """Return the module that each name in the stub of a package comes from."""
    return {
        alias.asname or alias.name: f"{package}.{node.module}" if node.level else f"{node.module}"
        for node in ast.walk(ast.parse(stub))
        if isinstance(node, ast.ImportFrom)
        for alias in node.names
    }


def _defined(tree: ast.Module) -> set[str]:
    """Return the functions, classes and constants of a module."""
    found = {getattr(node, "name", "") for node in tree.body}
    for node in tree.body:
        targets = node.targets if isinstance(node, ast.Assign) else [getattr(node, "target", None)]
        found |= {t.id for t in targets if isinstance(t, ast.Name)}
    return found - {""}


def _by_suffix(defined: Mapping[str, set[str]]) -> dict[str, list[str]]:
    """Return the modules by the texts that name something in them: ``a.b.C``, ``b.C`` for C in a.b."""
    found: dict[str, list[str]] = {}
    for module, names in defined.items():
        parts = module.split(".")
        for n in range(len(parts)):
            for name in names:
                found.setdefault(".".join([*parts[n:], name]), []).append(module)
    return found


def _by_string(
    node: ast.AST, module: str, defined: Mapping[str, set[str]], by_name: dict[str, list[str]]
) -> Iterator[str]:
    """Yield the modules that a string imports."""
    if isinstance(node, ast.Call) and ast.unparse(node.func).endswith("import_module"):
        for argument in node.args:
            text = argument.value if isinstance(argument, ast.Constant) else None
            if text in defined:
                yield str(text)
            if isinstance(argument, ast.JoinedStr) and isinstance(argument.values[0], ast.Constant):
                package = str(argument.values[0].value)
                yield from (m for m in defined if package.endswith(".") and m.startswith(package))
    elif (
        isinstance(node, ast.Constant)
        and isinstance(node.value, str)
        and DOTTED.fullmatch(node.value)
    ):
        package = module.partition(".")[0]
        yield from (m for m in by_name.get(node.value, ()) if m.startswith(f"{package}."))


def circles(needs: Graph) -> list[set[str]]:
    """Return the sets of modules each of which needs every other, largest first (Tarjan, 1972)."""
    number: dict[str, int] = {}
    least: dict[str, int] = {}
    stack: list[str] = []
    found = []
    for start in needs:
        if start in number:
            continue
        number[start] = least[start] = len(number)
        stack.append(start)
        path = [(start, iter(sorted(needs[start])))]
        while path:
            module, rest = path[-1]
            for target in rest:
                if target not in number:
                    number[target] = least[target] = len(number)
                    stack.append(target)
                    path.append((target, iter(sorted(needs[target]))))
                    break
                if target in stack:
                    least[module] = min(least[module], number[target])
            else:
                path.pop()
                if path:
                    least[path[-1][0]] = min(least[path[-1][0]], least[module])
                if least[module] == number[module]:
                    at = stack.index(module)
                    found.append(set(stack[at:]))
                    del stack[at:]
    return sorted((c for c in found if len(c) > 1), key=len, reverse=True)


if __name__ == "__main__":
    for circle in circles(graph(dict(sources()), stubs())):
        print(len(circle), *sorted(circle), sep="\n    ")
