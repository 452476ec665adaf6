"""Imports run one way: a package imports only packages of lower layers, and circles are listed."""

import ast
import re
from collections.abc import Iterable, Iterator
from functools import cache

import pytest

from tests.import_graph import ROOT, children, circles, graph, sources, stubs

# The parts of the packages by layers, lowest first. A part may import parts of lower layers, and itself.
LAYERS = [
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
        "hfield.verdicts",
        "hfield.core.primality",
        "hfield.core.progress",
        "hfield.core.sparse_rows",
        "hfield.core.straight_line",
        "hfield.rotation",
        "hfield.anim",
    },
    {"hfield.compiling", "hfield.core.factorisation"},
    {"hfield.fields.base", "hfield.fields.rationals.rational_numbers"},
    {"hfield.fields.algebraic", "hfield.fields.rationals.ring", "hfield.fields.rationals.squares"},
    {"hfield.fields.finite", "hfield.fields.floats", "hfield.fields.rationals.whole_numbers"},
    {"hfield.fields.polynomial_rings"},
    {"hfield.fields.linear_algebra"},
    {"hfield.fields.quadratic_forms"},
    {"hfield.fields.local"},
    {"hfield.fields"},  # the kinds of fields with places, and the names of all
    {"hfield.algebra.structure"},
    {"hfield.notation", "hfield.algebra.embedding", "hfield.latex"},
    {"hfield.presenting", "hfield.symbols"},
    {"hfield.algebra.quaternion"},  # lattices stand on the element, and the algebra makes lattices
    {
        "hfield.functions",
        "hfield.algebra.maps",
        "hfield.orders",
        "hfield.matrices",
        "hfield.former_names",
    },
    {"hfield.polynomials"},  # names in texts mean the same as in matrices
    {"hfield.exploring"},  # stands on the element and on maps, and the algebra hands over to it
    {"hfield.orders.elliptic_points"},
    {"hfield.fuchsian"},  # stands on orders as values, and what a user holds hands over to it
    {"hfield.orders.equivalence"},  # looks for elements in the hyperbolic plane
    {"hfield.orders.isomorphism", "hfield.orders.element_factors"},
    {"hfield.orders.lattice"},
    {"hfield.orders.hurwitz_order", "hfield.orders.foreign_texts"},
    {"hfield.algebra"},
    {"hfield.description", "hfield.surveys"},
    {"hfield.prover"},
    {"hfield.ledger"},
    {"hfield.export", "hfield.report"},
    {"hfield.repl"},
    {"hfield.cli"},
    {"hfield.__main__"},
    {"rotation.array_types", "rotation.errors"},
    {"rotation.hints", "rotation.native", "rotation.pytrees", "rotation.thesis"},
    {"rotation.arrays", "rotation.thread_count"},
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
    {"rotation.program_axes", "rotation.curves", "rotation.uncertain", "rotation.exact"},
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
    {"anim.viewer", "anim.given_motion", "anim.matplotlib_axes"},
    {"anim.top"},
    {"anim.ledger"},
    {"anim.commands", "anim.report"},
]
LAYER_OF = {part: n for n, layer in enumerate(LAYERS) for part in layer}
# Packages whose stub lists names of all layers; no part of the same package imports one of these from it.
STUBBED = {"hfield", "rotation", "anim"}
# Modules that import each other in a circle, and why; no such circle may be larger than MAX_CIRCLE.
CIRCLES = {
    ("hfield.fields.number_fields",): "a field, its places, ideals, classes and units are one idea",
    ("hfield.algebra", "hfield.description"): "a notebook shows an algebra by its description",
    (
        "hfield.cli.catalogue",
        "hfield.cli.commands",
    ): "the catalogue imports commands by name, and completion lists them all",
    ("rotation.exact", "rotation.rotation"): "Rotation.from_exact reads what exact makes",
}
MAX_CIRCLE = 20
# Parts that import kinds of fields with places: lattices, which are over ℤ or the integers of a number field,
# so that their places, ideals and integral bases are those of these fields.
KNOW_KINDS = {
    "hfield.orders",
    "hfield.orders.elliptic_points",
}
# Packages in which no module uses private names of another.
DISCREET = {"hfield.orders"}


def part_of(module: str) -> str:
    return next(
        (r for r in sorted(LAYER_OF, key=len, reverse=True) if f"{module}.".startswith(f"{r}.")), ""
    )


def statements(node: ast.AST) -> Iterator[ast.AST]:
    """Yield the statements below a node that may run, at all depths; expressions contain none."""
    for child in children(node):
        if not isinstance(child, ast.expr):
            yield child
            yield from statements(child)


@cache
def imports(source: str, package: str) -> set[str]:
    """All modules that a source imports, also inside functions; ``from x import y`` counts as x.y too.

    Imports under ``if TYPE_CHECKING`` only name types.
    """
    found = set()
    for node in statements(ast.parse(source)):
        if isinstance(node, ast.Import):
            found |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, f"a relative import in {package}: write it in full"
            inside = {f"{node.module}.{alias.name}" for alias in node.names}
            found |= inside
            if not inside <= modules():  # a name of the package itself
                found.add(node.module or "")
    return found


@cache
def modules() -> set[str]:
    """The names of all modules."""
    return {module for module, _ in sources()}


def breaches(module: str, source: str) -> list[str]:
    """The imports of ``module`` that do not run downwards."""
    here = part_of(module)
    return [
        f"{module} (layer of {here}) imports {target}"
        for target in imports(source, module)
        if part_of(target) != here
        and (
            LAYER_OF[part_of(target)] >= LAYER_OF[here]
            if part_of(target)
            else from_own_stub(here, target)
        )
    ]


def kinds_known(module: str, source: str) -> set[str]:
    """The kinds of fields with places, folders of hfield.fields, that a module imports."""
    parts = ("hfield.fields", "hfield.fields.local")
    folders = (t.split(".") for t in imports(source, module) if part_of(t) in parts)
    return {folder[2] for folder in folders if len(folder) > 2} & kinds()


@cache
def kinds() -> set[str]:
    """The folders of hfield.fields."""
    return {path.parent.name for path in (ROOT / "hfield/fields").glob("*/__init__.py")}


def from_own_stub(part: str, target: str) -> bool:
    """Whether the target is a name in the stub of the part's own package."""
    package, _, name = target.partition(".")
    if name == "__version__":
        return False
    return bool(name) and package in STUBBED and package == part.partition(".")[0]


@pytest.mark.slow
def test_imports_run_downwards() -> None:
    for module, source in sources():
        if module not in STUBBED:
            assert part_of(module), f"{module} is in no layer: add its part to LAYERS"
            assert breaches(module, source) == []


def test_the_check_can_fail() -> None:
    assert breaches("hfield.fields.base.ring", "def f():\n    from hfield.ledger import claim\n")
    assert breaches("hfield.algebra.structure.x", "import hfield.algebra\n")
    assert breaches("hfield.orders.x", "from hfield.algebra import QuaternionAlgebra\n")
    assert not breaches("hfield.orders.x", "from hfield.algebra.quaternion import Quaternion\n")
    assert breaches("rotation.arrays", "from rotation import Rotation\n")
    assert not breaches("hfield.algebra", "from hfield.core import product\n")


@pytest.mark.slow
def test_only_orders_import_kinds_of_fields() -> None:
    """Outside its folder a kind of field is known by what it can do, by data and by names."""
    importers = {part_of(module) for module, source in sources() if kinds_known(module, source)}
    within = {part for part in importers if part.startswith("hfield.fields")}
    assert importers - within - {"hfield.checker"} == KNOW_KINDS


@pytest.mark.slow
def test_circles_of_imports_are_listed() -> None:
    """Modules that need each other lie in one package and are one idea; strings count as imports."""
    for found in circles(graph(dict(sources()), stubs())):
        inside = [roots for roots in CIRCLES if all(_is_in(roots, module) for module in found)]
        assert inside, f"these modules import each other in a circle: {sorted(found)}"
        assert len(found) <= MAX_CIRCLE, f"{len(found)} modules in one circle: {sorted(found)}"


def _is_in(roots: tuple[str, ...], module: str) -> bool:
    return any(f"{module}.".startswith(f"{root}.") for root in roots)


def test_circles_are_found() -> None:
    lazily = "def f():\n    match 1:\n        case 1:\n            from hfield.fields.a import x\n"
    typed = "if TYPE_CHECKING:\n    from hfield.fields import a\nelse:\n    import hfield.errors\n"
    above = "from hfield.fields import b\n"
    both = {"hfield.fields.a", "hfield.fields.b"}
    assert circles(graph({"hfield.fields.a": above, "hfield.fields.b": lazily})) == [both]
    assert not circles(graph({"hfield.fields.a": above, "hfield.fields.b": typed}))


def test_names_that_a_package_hands_on_lead_to_their_modules() -> None:
    modules = {
        "hfield.fields": "",
        "hfield.fields.a": "from hfield.fields import b\nx = 1\n",
        "hfield.fields.b": "from hfield.fields import a, x\n",
    }
    stub = {"hfield.fields": "from .a import x as x\n"}
    assert graph(modules, stub) == {
        "hfield.fields": set(),
        "hfield.fields.a": {"hfield.fields.b"},
        "hfield.fields.b": {"hfield.fields.a", "hfield.fields"},
    }
    assert circles(graph(modules | {"hfield.fields.b": "from hfield.fields import x\n"}, stub))


def test_imports_by_string_are_found() -> None:
    below = {"hfield.fields.kinds.field": "class Field: ...\n"}
    for text in (
        "theory = 'kinds.field.Field'\n",
        "def f():\n    return import_module('hfield.fields.kinds.field')\n",
        "def f(name):\n    return importlib.import_module(f'hfield.fields.kinds.{name}')\n",
    ):
        found = graph(below | {"hfield.fields.a": text})
        assert found["hfield.fields.a"] == {"hfield.fields.kinds.field"}, text
    apart = graph(below | {"rotation.a": "message = 'kinds.field.Field'\n"})
    assert apart["rotation.a"] == set()


def test_the_checker_of_certificates_stands_alone() -> None:
    for module, source in sources():
        if module.startswith("hfield.checker"):
            outside = {t for t in imports(source, module) if t.startswith("hfield")}
            assert all(t.startswith("hfield.checker") for t in outside), (module, outside)


# What is written a second time for others: the checker stands alone, and rotation.compat has scipy's names.
REPEATS = ("hfield.checker", "rotation.compat")
_CLASS = re.compile(r"^ *class (\w+)[(:\[]", re.MULTILINE)


def repeated_classes(texts: Iterable[tuple[str, str]]) -> dict[str, list[str]]:
    """Return the names of classes with their modules, where two modules of one side define one."""
    found: dict[tuple[str, str], list[str]] = {}
    for module, source in texts:
        side = next((r for r in REPEATS if f"{module}.".startswith(f"{r}.")), "")
        for name in _CLASS.findall(source):
            found.setdefault((side, name), []).append(module)
    return {name: places for (_, name), places in found.items() if len(places) > 1}


def test_a_class_name_is_defined_once() -> None:
    assert repeated_classes(sources()) == {}
    twice = [("hfield.a", "class Word:\n"), ("rotation.b", "if x:\n    class Word(str):\n")]
    assert repeated_classes(twice) == {"Word": ["hfield.a", "rotation.b"]}
    assert not repeated_classes([twice[0], ("hfield.checker.b", "class Word[T]:\n")])


def looked_into(source: str) -> set[str]:
    """The private names of other objects that a module asks for and does not define itself."""
    own, foreign = set(), set()
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.FunctionDef):
            own.add(node.name)
        elif isinstance(node, ast.Attribute):
            of_itself = isinstance(node.value, ast.Name) and node.value.id in ("self", "cls")
            (own if of_itself else foreign).add(node.attr)
    return {name for name in foreign - own if name.startswith("_") and not name.endswith("__")}


def test_no_private_attribute_of_another_module_is_used() -> None:
    found = {module: looked_into(text) for module, text in sources() if part_of(module) in DISCREET}
    assert {module: names for module, names in found.items() if names} == {}
    assert looked_into("def f(x):\n    return x._rows\n") == {"_rows"}
    assert not looked_into("class A:\n    def f(self, x):\n        return self._a + x._a\n")
