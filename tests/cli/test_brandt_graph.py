"""Graphs of Brandt matrices: the same file each time, a layout by distances, curves over the prime field."""

import re

import numpy as np
import pytest

from hfield import QuaternionAlgebra
from hfield.cli import main
from hfield.cli.commands.brandt_graph import MAX_NUMBERED_EDGES, BrandtGraph, figure, layout
from tests.subcases import first_quick


def write(path, *words: str) -> bytes:
    assert main(["brandt", *words, "--plot", str(path)]) == 0
    return path.read_bytes()


@pytest.mark.parametrize("suffix", first_quick(["svg", "pdf", "png"], 1))
def test_a_graph_is_the_same_file_each_time(tmp_path, suffix) -> None:
    path = tmp_path / f"graph.{suffix}"
    assert write(path, "37") == write(path, "37")


def test_dark_pages_are_dark(tmp_path) -> None:
    light, dark = (write(tmp_path / "a.svg", "11", *more) for more in ((), ("--dark",)))
    assert b"#11141b" in dark
    assert b"#11141b" not in light


def test_too_many_classes_are_refused(tmp_path, capsys) -> None:
    assert main(["brandt", "10007", "--plot", str(tmp_path / "a.svg")]) == 2
    assert "at most 600 vertices" in capsys.readouterr().err


def test_a_path_and_a_cycle_are_laid_out_as_what_they_are() -> None:
    count = 12
    path = np.eye(count, k=1, dtype=int) + np.eye(count, k=-1, dtype=int)
    shuffled = np.random.default_rng(0).permutation(count)
    x, y = layout(path[np.ix_(shuffled, shuffled)].tolist()).T
    assert np.argsort(x).tolist() in (np.argsort(shuffled).tolist(), np.argsort(-shuffled).tolist())
    assert np.abs(y).max() < 0.1
    path[0, -1] = path[-1, 0] = 1
    places = layout(path.tolist())
    radii = np.linalg.norm(places, axis=1)
    assert np.ptp(radii) < 0.01 * radii.mean()
    sides = np.linalg.norm(places - np.roll(places, 1, axis=0), axis=1)
    assert np.ptp(sides) < 0.01 * sides.mean()


def test_components_and_single_vertices_are_apart() -> None:
    assert layout([[3]]).tolist() == [[0, 0]]
    places = layout([[1, 0, 0], [0, 0, 1], [0, 1, 0]])
    apart = np.linalg.norm(places[:, None] - places, axis=-1)[np.triu_indices(3, 1)]
    assert apart.min() > 0.5


@pytest.mark.parametrize("p", [11, 37, 83, 103])
def test_curves_over_the_prime_field_are_those_that_frobenius_fixes(p: int) -> None:
    conjugates = QuaternionAlgebra(p).maximal_order().class_set().exchanged(p)
    assert sum(n == m for n, m in enumerate(conjugates)) == len(supersingular_invariants(p))


def supersingular_invariants(p: int) -> set[int]:
    """Return the supersingular j in the field of p > 3 elements: of the curves with p + 1 points."""
    roots = [sum(pow(y, 2, p) == x for y in range(p)) for x in range(p)]
    found = set()
    for a in range(p):
        for b in range(p):
            size = (4 * a**3 + 27 * b**2) % p
            if size and 1 + sum(roots[(x**3 + a * x + b) % p] for x in range(p)) == p + 1:
                found.add(1728 * 4 * a**3 * pow(size, -1, p) % p)
    return found


def shown(graph: BrandtGraph) -> tuple[list[str], list[str]]:
    """Return the texts, and the kinds of patches, that are drawn."""
    axes = figure(graph).axes[0]
    return [t.get_text() for t in axes.texts], [type(p).__name__ for p in axes.patches]


def test_directions_multiplicities_and_loops_are_drawn() -> None:
    graph = BrandtGraph([[0, 2, 1], [3, 0, 0], [1, 0, 7]], [4, 6, 2], "A graph")
    texts, patches = shown(graph)
    assert sorted(t for t in texts if re.fullmatch(r"[2-9]", t)) == sorted(
        ["2", "3", "7", "2", *"246"]
    )
    assert patches.count("FancyArrowPatch") == 2
    assert patches.count("Circle") == 3 + 1 + 3  # vertices, a loop, sizes in the legend
    assert figure(graph).texts[0].get_text() == "A graph"


def test_areas_of_vertices_are_as_their_numbers_of_units() -> None:
    from matplotlib.patches import Circle

    graph = BrandtGraph([[0, 2], [3, 0]], [4, 6], "A graph")
    circles = [p.radius for p in figure(graph).axes[0].patches if isinstance(p, Circle)]
    assert circles[1] ** 2 / circles[0] ** 2 == pytest.approx(6 / 4)


def test_conjugate_curves_have_another_colour() -> None:
    texts, _ = shown(BrandtGraph([[0, 1], [1, 0]], [2, 2], "A graph", conjugates=[1, 0]))
    assert "one of two conjugate curves" in texts
    assert (
        "one of two conjugate curves" not in shown(BrandtGraph([[1]], [24], "A", conjugates=[0]))[0]
    )


def test_of_many_edges_the_legend_says_that_numbers_are_left_out() -> None:
    count = 20
    assert count * (count - 1) / 2 > MAX_NUMBERED_EDGES
    texts, patches = shown(BrandtGraph([[2] * count] * count, [2] * count, "A graph"))
    assert any("left out" in text for text in texts)
    assert "FancyArrowPatch" not in patches
