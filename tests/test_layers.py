"""The floors of the house: a room imports only what stands below it, and there is no circle."""

import ast
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent
# From the ground up. A room may import rooms of lower floors, and its own.
FLOORS = [
    {"hfield.errors", "hfield.product", "hfield.certificates", "hfield.hints", "hfield.handed_on"},
    {
        "hfield.syntax",
        "hfield.executors",
        "hfield.atomic",
        "hfield.primality",
        "hfield.straight_line",
        "hfield.native",
        "hfield.rotation",
        "hfield.anim",
    },
    {"hfield.kernels", "hfield.factorisation"},
    {"hfield.rings"},
    {"hfield.notation", "hfield.embedding", "hfield.latex"},
    {"hfield.structure"},
    {"hfield.elements", "hfield.batches"},
    {"hfield.element_text"},
    {"hfield.quaternion"},
    {"hfield.functions", "hfield.maps", "hfield.array_makers", "hfield.lattices"},
    {"hfield.invariants", "hfield.order_makers"},
    {"hfield.algebra"},
    {"hfield.description", "hfield.census"},
    {"hfield.proving"},
    {"hfield.ledger"},
    {"hfield.coq", "hfield.report"},
    {"hfield.repl"},
    {"hfield.commands"},
    {"hfield.cli"},
    {"hfield.__main__"},
    {"rotation.errors", "rotation.hints", "rotation.native", "rotation.thesis"},
    {"rotation.arrays", "rotation.pool"},
    {"rotation.sampling"},
    {"rotation.namespaces", "rotation.plane"},
    {"rotation.rowwise", "rotation.shaped"},
    {"rotation.coordinates", "rotation.angles"},
    {"rotation.compensated", "rotation.optimum"},
    {"rotation.quaternions", "rotation.matrices"},
    {"rotation.vectors", "rotation.euler", "rotation.averaging"},
    {"rotation.davenport", "rotation.groups"},
    {"rotation.acting", "rotation.jacobians", "rotation.magnus"},
    {"rotation.kernels", "rotation.shown"},
    {"rotation.batch", "rotation.products"},
    {"rotation.wahba", "rotation.fused", "rotation.rigid_motions", "rotation.screws"},
    {"rotation.conversions"},
    {"rotation.gathering"},
    {"rotation.rotation"},
    {"rotation.interpolation", "rotation.alignment", "rotation.angular_velocity"},
    {"rotation.rigid_forms"},
    {"rotation.rigid", "rotation.swing", "rotation.spline"},
    {"rotation.conventions"},
    {"rotation.compat"},
    {"rotation.warming"},
    {"rotation.figures"},
    {"rotation.bench"},
    {"rotation.ledger"},
    {"rotation.commands", "rotation.report"},
    {"anim.errors", "anim.attitude", "anim.catalogue", "anim.compiling"},
    {"anim.checks"},
    {"anim.model", "anim.film", "anim.timeline"},
    {"anim.motion", "anim.picture", "anim.output"},
    {"anim.pipelines", "anim.bands", "anim.physics", "anim.rendering", "anim.viewer"},
    {"anim.top"},
    {"anim.ledger"},
    {"anim.commands", "anim.report"},
]
FLOOR = {room: n for n, floor in enumerate(FLOORS) for room in floor}
# A face hands out names of all floors, and no room of the same package asks it for one.
FACES = {"hfield", "rotation", "anim"}


def room_of(module: str) -> str:
    return next(
        (r for r in sorted(FLOOR, key=len, reverse=True) if f"{module}.".startswith(f"{r}.")), ""
    )


def imports(source: str, package: str) -> set[str]:
    """All modules that a source imports, also inside functions; ``from x import y`` counts as x.y too."""
    found = set()
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Import):
            found |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, f"a relative import in {package}: write it in full"
            found.add(node.module or "")
            found |= {f"{node.module}.{alias.name}" for alias in node.names}
    return found


def breaches(module: str, source: str) -> list[str]:
    """The imports of ``module`` that do not run downwards."""
    here = room_of(module)
    return [
        f"{module} (floor of {here}) imports {target}"
        for target in imports(source, module)
        if room_of(target) != here
        and (FLOOR[room_of(target)] >= FLOOR[here] if room_of(target) else own_face(here, target))
    ]


def own_face(room: str, target: str) -> bool:
    """Whether the target is a name that the room's own face hands out."""
    package, _, name = target.partition(".")
    if name == "__version__":
        return False
    return bool(name) and package in FACES and package == room.partition(".")[0]


def sources() -> list[tuple[str, str]]:
    out = []
    for package in ("hfield", "rotation", "anim"):
        for path in sorted((ROOT / package).rglob("*.py")):
            parts = path.relative_to(ROOT).with_suffix("").parts
            module = ".".join(parts[:-1] if parts[-1] == "__init__" else parts)
            out.append((module, path.read_text(encoding="utf-8")))
    return out


@pytest.mark.parametrize(
    ("module", "source"), sources(), ids=lambda x: x if len(x) < 60 else "source"
)
def test_imports_run_downwards(module: str, source: str) -> None:
    if module in FACES:
        return
    assert room_of(module), f"{module} stands on no floor: add its room to FLOORS"
    assert breaches(module, source) == []


def test_the_check_can_fail() -> None:
    assert breaches("hfield.rings.base", "def f():\n    from hfield.ledger import claim\n")
    assert breaches("hfield.structure.x", "import hfield.algebra\n")
    assert breaches("rotation.arrays", "from rotation import Rotation\n")
    assert not breaches("hfield.algebra", "from hfield import product\n")


def test_the_checker_of_certificates_stands_alone() -> None:
    for module, source in sources():
        if module.startswith("hfield.certificates"):
            outside = {t for t in imports(source, module) if t.startswith("hfield")}
            assert all(t.startswith("hfield.certificates") for t in outside), (module, outside)
