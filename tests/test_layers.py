"""Imports run one way: a package imports only packages of lower layers, and there is no circle."""

import ast
from collections.abc import Iterator
from functools import cache
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent
# From the ground up. A room may import rooms of lower floors, and its own.
FLOORS = [
    {
        "hfield.errors",
        "hfield.core",
        "hfield.core.product",
        "hfield.checker",
        "hfield.hints",
        "hfield.lazy_alias",
        "hfield.sympy_printing",
        "hfield.core.locks",
    },
    {"hfield.syntax", "hfield.evidence"},
    {
        "hfield.core.executors",
        "hfield.core.files",
        "hfield.plotting",
        "hfield.tables",
        "hfield.core.primality",
        "hfield.core.progress",
        "hfield.core.straight_line",
        "hfield.rotation",
        "hfield.anim",
    },
    {"hfield.compiling", "hfield.core.factorisation"},
    {"hfield.rings"},
    {"hfield.structure"},
    {"hfield.fields"},
    {"hfield.notation", "hfield.algebra.embedding", "hfield.latex"},
    {"hfield.presenting", "hfield.symbols"},
    {"hfield.algebra.quaternion"},  # lattices stand on the element, and the algebra makes lattices
    {
        "hfield.functions",
        "hfield.algebra.maps",
        "hfield.orders",
        "hfield.matrices",
        "hfield.quaternion",
        "hfield.element_text",
    },
    {"hfield.polynomials"},  # names in texts mean the same as in matrices
    {"hfield.exploring"},  # stands on the element and on maps, and the algebra hands over to it
    {"hfield.orders.elliptic_points"},
    {"hfield.fuchsian"},  # stands on orders as values, and what a user holds hands over to it
    {"hfield.orders.equivalence"},  # looks for elements in the hyperbolic plane
    {"hfield.orders.isomorphisms"},
    {"hfield.orders.lattice"},
    {"hfield.orders.hurwitz_order"},
    {"hfield.algebra"},
    {"hfield.description", "hfield.census"},
    {"hfield.prover"},
    {"hfield.ledger"},
    {"hfield.export", "hfield.report"},
    {"hfield.repl"},
    {"hfield.cli"},
    {"hfield.__main__"},
    {"rotation.errors"},
    {"rotation.hints", "rotation.native", "rotation.pytrees", "rotation.thesis"},
    {"rotation.arrays", "rotation.pool"},
    {"rotation.sampling"},
    {"rotation.namespaces"},
    {"rotation.immutable_arrays"},
    {"rotation.rowwise"},
    {"rotation.coordinates"},
    {"rotation.compensated", "rotation.optimum"},
    {"rotation.angles"},
    {"rotation.quaternions", "rotation.matrices", "rotation.plane"},
    {"rotation.vectors", "rotation.euler"},
    {"rotation.geodesic_median"},
    {"rotation.davenport", "rotation.groups", "rotation.averaging", "rotation.disorientation"},
    {"rotation.action", "rotation.jacobians"},
    {"rotation.kernels", "rotation.html_table"},
    {"rotation.batch", "rotation.products", "rotation.figures"},
    {"rotation.wahba", "rotation.fused", "rotation.rigid_motions"},
    {"rotation.conversions"},
    {"rotation.rotation"},
    {"rotation.alignment"},
    {"rotation.rigid_forms"},
    {"rotation.rigid", "rotation.swing_twist"},
    {"rotation.conventions", "rotation.curves", "rotation.uncertain", "rotation.exact"},
    {"rotation.compat"},
    {"rotation.precompile"},
    {"rotation.bench"},
    {"rotation.ledger"},
    {"rotation.commands", "rotation.report"},
    {"anim.errors", "anim.attitude", "anim.catalogue", "anim.compiling"},
    {"anim.checks"},
    {"anim.outline"},
    {"anim.model", "anim.film", "anim.timeline"},
    {"anim.motion", "anim.picture", "anim.output"},
    {"anim.pipelines", "anim.aliasing", "anim.physics", "anim.rendering"},
    {"anim.viewer", "anim.given_motion", "anim.in_axes"},
    {"anim.top"},
    {"anim.ledger"},
    {"anim.commands", "anim.report"},
]
FLOOR = {room: n for n, floor in enumerate(FLOORS) for room in floor}
# A face hands out names of all floors, and no room of the same package asks it for one.
FACES = {"hfield", "hfield.rings", "rotation", "anim"}
# Who asks for a kind of field by its name: lattices, which are over ℤ or the integers of a number field, so
# that their places, ideals and integral bases are those of these fields.
KNOW_KINDS = {
    "hfield.orders",
    "hfield.orders.elliptic_points",
}
# Rooms in which no module looks into what another keeps to itself.
DISCREET = {"hfield.orders"}


def room_of(module: str) -> str:
    return next(
        (r for r in sorted(FLOOR, key=len, reverse=True) if f"{module}.".startswith(f"{r}.")), ""
    )


def statements(node: ast.AST) -> Iterator[ast.AST]:
    """Yield the statements below a node, at all depths; expressions contain none."""
    for child in ast.iter_child_nodes(node):
        if not isinstance(child, ast.expr):
            yield child
            yield from statements(child)


@cache
def imports(source: str, package: str) -> set[str]:
    """All modules that a source imports, also inside functions; ``from x import y`` counts as x.y too."""
    found = set()
    for node in statements(ast.parse(source)):
        if isinstance(node, ast.Import):
            found |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, f"a relative import in {package}: write it in full"
            found.add(node.module or "")
            found |= {f"{node.module}.{alias.name}" for alias in node.names}
    return found


def running(node: ast.AST) -> Iterator[ast.AST]:
    """The nodes that may run: all but those under ``if TYPE_CHECKING``, which name types."""
    yield node
    typing = isinstance(node, ast.If) and ast.unparse(node.test) == "TYPE_CHECKING"
    for child in node.orelse if typing else ast.iter_child_nodes(node):
        yield from running(child)


def graph(modules: list[tuple[str, str]]) -> dict[str, set[str]]:
    """Which modules each imports when it runs."""
    names = {module for module, _ in modules}
    found: dict[str, set[str]] = {module: set() for module in names}
    for module, source in modules:
        for node in running(ast.parse(source)):
            if isinstance(node, ast.Import):
                targets = {alias.name for alias in node.names}
            elif isinstance(node, ast.ImportFrom):  # of a module in x, or of a name in the module x
                inside = {f"{node.module}.{alias.name}" for alias in node.names}
                targets = inside & names | ({node.module or ""} if inside - names else set())
            else:
                continue
            found[module] |= targets & names - {module}
    return found


def circle(imports: dict[str, set[str]]) -> list[str]:
    """Modules of which each is imported by the next, the first one again at the end; [] if there are none."""
    try:
        TopologicalSorter(imports).prepare()
    except CycleError as error:
        return list(error.args[1])
    return []


def breaches(module: str, source: str) -> list[str]:
    """The imports of ``module`` that do not run downwards."""
    here = room_of(module)
    return [
        f"{module} (floor of {here}) imports {target}"
        for target in imports(source, module)
        if room_of(target) != here
        and (FLOOR[room_of(target)] >= FLOOR[here] if room_of(target) else own_face(here, target))
    ]


def kinds_known(module: str, source: str) -> set[str]:
    """The kinds of fields, folders of hfield.fields, that a module imports."""
    parts = (target.split(".") for target in imports(source, module))
    return {p[2] for p in parts if p[:2] == ["hfield", "fields"] and len(p) > 2} & kinds()


@cache
def kinds() -> set[str]:
    """The folders of hfield.fields."""
    return {path.parent.name for path in (ROOT / "hfield/fields").glob("*/__init__.py")}


def own_face(room: str, target: str) -> bool:
    """Whether the target is a name that the room's own face hands out."""
    package, _, name = target.partition(".")
    if name == "__version__":
        return False
    return bool(name) and package in FACES and package == room.partition(".")[0]


@cache
def sources() -> list[tuple[str, str]]:
    """Every module of the three packages with its text."""
    out = []
    for package in ("hfield", "rotation", "anim"):
        for path in sorted((ROOT / package).rglob("*.py")):
            parts = path.relative_to(ROOT).with_suffix("").parts
            module = ".".join(parts[:-1] if parts[-1] == "__init__" else parts)
            out.append((module, path.read_text(encoding="utf-8")))
    return out


@pytest.mark.slow
def test_imports_run_downwards() -> None:
    for module, source in sources():
        if module not in FACES:
            assert room_of(module), f"{module} stands on no floor: add its room to FLOORS"
            assert breaches(module, source) == []


def test_the_check_can_fail() -> None:
    assert breaches("hfield.rings.base", "def f():\n    from hfield.ledger import claim\n")
    assert breaches("hfield.structure.x", "import hfield.algebra\n")
    assert breaches("hfield.orders.x", "from hfield.algebra import QuaternionAlgebra\n")
    assert not breaches("hfield.orders.x", "from hfield.algebra.quaternion import Quaternion\n")
    assert breaches("rotation.arrays", "from rotation import Rotation\n")
    assert not breaches("hfield.algebra", "from hfield.core import product\n")


def test_only_orders_import_kinds_of_fields() -> None:
    """Outside its folder a kind of field is known by what it can do, by data and by names."""
    asked = {room_of(module) for module, source in sources() if kinds_known(module, source)}
    assert asked - {"hfield.checker"} == {"hfield.fields", *KNOW_KINDS}


@pytest.mark.slow
def test_no_imports_in_circles() -> None:
    assert circle(graph(sources())) == []


def test_circles_are_found() -> None:
    lazily = "def f():\n    match 1:\n        case 1:\n            from hfield.rings.a import x\n"
    typed = "if TYPE_CHECKING:\n    from hfield.rings import a\nelse:\n    import hfield.errors\n"
    above = ("hfield.rings.a", "from hfield.rings import b\n")
    assert circle(graph([above, ("hfield.rings.b", lazily)]))
    assert not circle(graph([above, ("hfield.rings.b", typed)]))
    face = ("hfield.rings", "from hfield.rings.a import x, y\n")
    below = ("hfield.rings.b", "from hfield.rings import a, x\n")
    assert graph([above, below, face]) == {
        "hfield.rings.a": {"hfield.rings.b"},
        "hfield.rings.b": {"hfield.rings.a", "hfield.rings"},
        "hfield.rings": {"hfield.rings.a"},
    }


def test_the_checker_of_certificates_stands_alone() -> None:
    for module, source in sources():
        if module.startswith("hfield.checker"):
            outside = {t for t in imports(source, module) if t.startswith("hfield")}
            assert all(t.startswith("hfield.checker") for t in outside), (module, outside)


def looked_into(source: str) -> set[str]:
    """The private names of other objects that a module asks for and does not define itself."""
    own, asked = set(), set()
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.FunctionDef):
            own.add(node.name)
        elif isinstance(node, ast.Attribute):
            of_itself = isinstance(node.value, ast.Name) and node.value.id in ("self", "cls")
            (own if of_itself else asked).add(node.attr)
    return {name for name in asked - own if name.startswith("_") and not name.endswith("__")}


def test_no_private_attribute_is_asked_of_another_module() -> None:
    found = {module: looked_into(text) for module, text in sources() if room_of(module) in DISCREET}
    assert {module: names for module, names in found.items() if names} == {}
    assert looked_into("def f(x):\n    return x._rows\n") == {"_rows"}
    assert not looked_into("class A:\n    def f(self, x):\n        return self._a + x._a\n")
