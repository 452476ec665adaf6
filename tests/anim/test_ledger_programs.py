"""Claims about the programs and pictures of sections 3.3 and 3.4: counted, inspected, and the code proved."""

import importlib
import json
import subprocess
import sys
from typing import Any

import numpy as np
import pytest

from anim import Model, Timeline, compare, kinematic
from anim.film import Clip
from anim.ledger import CLAIMS, optimised
from anim.ledger.turning import UP, rotation, turned
from hfield.cli import main
from hfield.core.product import Constants, conjugate, multiply
from hfield.fields.names import ring
from hfield.ledger.claim import NO_FIELD, decide
from hfield.prover.statements.printing import to_text
from hfield.syntax import number
from rotation.ledger.entries import vector
from rotation.ledger.symbolic_runs import code
from rotation.matrices import R_x, R_y, R_z
from tests.ledger.spoilt_thesis import spoilt_thesis


def verdict(name: str) -> str:
    (claim,) = (c for c in CLAIMS if c.id == name)
    return decide(claim, NO_FIELD).as_printed.verdict


def test_counts_are_counted(monkeypatch: Any) -> None:
    """A model without its last quadrilateral, and a sheet without its first frame, turn rows red."""
    monkeypatch.setattr(Model, "sides", property(lambda self: self.upper[:-1, [0, 1, 1, 0]]))
    sheet = importlib.import_module("anim.output.sheet")
    monkeypatch.setattr(sheet, "shown", lambda frames: [49, 99])
    rows = ("C3.3-d", "C3.3-e", "C3.4.1-m", "C3.4.3-f", "C3.3-g")
    assert [verdict(name) for name in rows] == [*["refuted"] * 4, "proved"]
    monkeypatch.undo()
    assert {verdict(name) for name in rows} == {"proved"}


def test_linspace_is_inspected_and_run(monkeypatch: Any) -> None:
    true = np.linspace
    monkeypatch.setattr(np, "linspace", lambda a, b, num=50: true(a, b, num, endpoint=False))
    assert [verdict(name) for name in ("C3.4-a", "C3.4-b", "C3.4-c")] == ["refuted"] * 2 + [
        "proved"
    ]


def test_the_values_are_those_of_the_timeline(monkeypatch: Any) -> None:
    monkeypatch.setattr("anim.timeline.RADIUS", (0.0, 1 / 3))
    assert verdict("C3.4.1-i") == "refuted"


MUTANTS = {
    "2 * (c * d - a * b)": ("2 * (c * d + a * b)", {"C3.4.4-c", "C3.4.4-d"}),
    "[a, [-v[0], -v[1]": ("[a, [-v[0], v[1]", {"C3.4.2-e", "C3.4.2-g"}),
    "return [[1, 0, 0], [0, c, -s], [0, s, c]]": (
        "return [[1, 0, 0], [0, c, s], [0, -s, c]]",
        set(),  # rotationMatrixZYX calls it, and agrees with it still
    ),
}
MODULES = ("optimised", "euler_angles", "quaternion_matrix")


@pytest.mark.slow
@pytest.mark.parametrize("line", MUTANTS)
def test_what_is_proved_is_the_code(line: str) -> None:
    mutant, expected = MUTANTS[line]
    red = set()
    with spoilt_thesis(line, mutant, "anim.ledger", MODULES) as spoilt:
        computed = {
            name for module in MODULES for name in sys.modules[f"anim.ledger.{module}"].COMPUTED
        }
        for claim in spoilt:
            if claim.id in computed and claim.fieldless:
                row = decide(claim, NO_FIELD)
                said = row.as_corrected or row.as_printed
                red |= {claim.id} if said.verdict != "proved" else set()
    assert red == expected


def note(name: str) -> str:
    (claim,) = (c for c in CLAIMS if c.id == name)
    return claim.note


def test_the_figures_in_the_notes() -> None:
    together = compare()
    here, there = (together.names.index(name) for name in ("quaternions", "euler"))
    for radians in (
        together.axes[here, there],
        together.attitudes[here, there],
        compare(reading=Timeline(angle="half")).tilts[here],
        together.tilts[there],
    ):
        assert f"{np.degrees(radians):.1f}°" in note("C3.4.3-b")
    assert f"tilt of {np.degrees(together.tilts[here]):.1f}°" in note("C3.4.1-d")
    assert (
        max(compare(reading=Timeline(angle=a)).tilts[here] for a in np.linspace(0, 2 * np.pi, 9))
        <= 2 * np.arcsin(1 / 4) + 1e-12
    )
    spin = Timeline().at(np.linspace(0, 1, 500), 10).spin
    step = np.diff(spin)
    assert f"({-np.degrees(step[0]):.1f}°" in note("C3.4.1-j")
    assert f"{-step[-1] * 50:.0f} rad/s" in note("C3.4.1-j")
    # The rim of P₁, at the radius 1 and the height 1, is on the ground when the top leans by 45°.
    assert "45°" in note("C3.4.1-d")
    assert (np.asarray(R_x(np.pi / 4)) @ [0, -1, 1])[2] == pytest.approx(0)
    assert f"{27**-0.5:.3f}" in note("C3.3-b")
    assert f"{Model(ring=4).triangles()[0].shape[0]}" == "16"  # four a point: 4000 for 1000
    assert "4000 triangles" in note("C3.3-k")


def test_rodrigues_formula_on_terms() -> None:
    about = vector("2/3, -1/3, 2/3")
    c, s = vector("3/5, 4/5")
    terms = turned(about, vector("1, 2, 3"), c, s)
    field = ring("QQ")
    found = [float(field(to_text(term))) for term in terms]
    u, v = np.array([2, -1, 2]) / 3, np.array([1, 2, 3])
    wanted = 0.6 * v + 0.8 * np.cross(u, v) + 0.4 * (u @ v) * u
    assert found == pytest.approx(wanted)
    for letter, matrix in (("x", R_x), ("y", R_y), ("z", R_z)):
        rows = [[float(field(to_text(x))) for x in row] for row in rotation(letter, c, s)]
        assert np.array(rows) == pytest.approx(np.asarray(matrix(np.arctan2(4, 3))))
        along = tuple(number(int(name == letter)) for name in "xyz")
        tilted = [float(field(to_text(term))) for term in turned(along, UP, c, s)]
        assert tilted == pytest.approx([row[2] for row in rows])


def attitude(x: Any, r: float) -> tuple[Any, ...]:
    """The coordinates of the rotation by π/2 about the axis of section 3.4.1."""
    parts = (np.ones_like(x), r * np.cos(x), r * np.sin(x), np.full_like(x, np.sqrt(1 - r * r)))
    return tuple(part / np.sqrt(2) for part in parts)


def test_the_spin_of_its_own_by_differences() -> None:
    x, small, hamilton = np.linspace(0, 6, 13), 1e-6, Constants(-1.0, 0.0, -1.0)
    for r in (0.5, 0.25):
        ends = zip(attitude(x + small, r), attitude(x - small, r), strict=True)
        change = tuple((after - before) / (2 * small) for after, before in ends)
        body = multiply(hamilton, conjugate(hamilton, attitude(x, r)), change)
        assert 2 * body[3] == pytest.approx(-r * r, abs=1e-9)
        assert 2 * body[0] == pytest.approx(0, abs=1e-9)


def test_the_last_frame_by_the_pipelines() -> None:
    quaternions, euler = (
        kinematic(name, Clip()).matrices[-1, :, 2] for name in ("product", "euler")
    )
    assert quaternions == pytest.approx([np.sqrt(15) / 16, -1 / 4, 15 / 16])
    assert euler == pytest.approx([0, -np.sin(1 / 2), np.cos(1 / 2)])


def test_multiplications_are_counted() -> None:
    t = optimised.MultiplicationCounter()
    code("crossProduct")([t, t, t], [t, t, t])
    assert t.count == 6
    one, other = optimised.work(1), optimised.work(1001)
    assert other[0] - one[0] == 1000 * one[0]
    assert optimised.saves(2).compute().holds
    assert not optimised.saves(3).compute().holds


@pytest.mark.parametrize("section", ["3.3", "3.4.2", "3.5", "4"])
def test_from_the_command_line(section: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["verify", "--section", section, "--format", "json"]) == 0
    results = json.loads(capsys.readouterr().out)["results"]
    wanted = [c for c in CLAIMS if c.section == section]
    assert {row["id"] for row in results} == {c.id for c in wanted}
    assert len(results) == sum(len(c.fields) for c in wanted)


@pytest.mark.slow
def test_listing_the_claims_loads_no_numpy() -> None:
    script = "import sys, anim.ledger; print('numpy' in sys.modules)"
    out = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    assert out.stdout.strip() == "False"
