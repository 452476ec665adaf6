"""Outlines of one's own: what is accepted and refused, the solid that is drawn, and its physics."""

from math import inf, nan, pi

import numpy as np
import pytest

from anim.errors import AnimationError
from anim.model import Model
from anim.outline import simplified
from anim.physics import Body, physical
from anim.physics.films import STORY, story_of
from hfield.cli import main
from hfield.errors import TableError

EGG = [(0, 0), (1, 0.8), (2, 1), (3, 0.6), (3.5, 0)]


def test_the_thesis_top_by_its_outline_is_the_thesis_top() -> None:
    usual = Model(ring=30)
    own = Model.from_outline([(z, r) for r, z in usual.profile], ring=30)
    assert own == usual
    np.testing.assert_array_equal(own.points, usual.points)
    assert own.polygons == usual.polygons


@pytest.mark.parametrize(
    "outline", [EGG, [(0, 1), (2, 1)], [(5, 0), (5, 2), (6, 2), (6, 1), (9, 0)]]
)
def test_the_surface_is_closed_and_holds_the_volume_of_its_frusta(outline) -> None:
    model = Model.from_outline(outline, ring=400)
    faces, bands = model.triangles()
    edges = [(f[i], f[(i + 1) % 3]) for f in faces.tolist() for i in range(3)]
    assert len(set(edges)) == len(edges) == 3 * len(bands)
    assert {(b, a) for a, b in edges} == set(edges)
    a, b, c = (model.points[faces[:, k]] for k in range(3))
    volume = np.sum(a * np.cross(b, c)) / 6
    r, z = np.array(model.profile).T
    exact = pi / 3 * np.sum(np.diff(z) * (r[1:] ** 2 + r[1:] * r[:-1] + r[:-1] ** 2))
    assert volume == pytest.approx(exact, rel=1e-4)


def test_the_lowest_point_is_put_on_the_ground_and_open_ends_are_closed() -> None:
    assert Model.from_outline([(-1, 0.5), (1, 0.5)]).profile == ((0, 0), (0.5, 0), (0.5, 2), (0, 2))
    assert Model.from_outline(np.array(EGG)).profile[-1] == (0, 3.5)


@pytest.mark.parametrize(
    ("outline", "words"),
    [
        ([], "0 points; expected 2"),
        ([(0, 1)], "1 point; expected 2"),
        ([(0, 0), (1, -1), (2, 0)], "point 2 of the outline: the radius is -1"),
        ([(0, 0), (2, 1), (1, 1)], "point 3 of the outline: z is 1, below the 2"),
        ([(0, 0), (1, nan), (2, 0)], "point 2 of the outline: the radius is nan"),
        ([(0, 0), (inf, 1)], "point 2 of the outline: z is inf"),
        ([(0, 0), (1, 2, 3)], "point 2 of the outline is"),
        ([(0, 0), (1, "a")], "a real number"),
        ([(0, 0), (1, 1), (2, 0), (3, 1)], "split the top"),
        ([(0, 1), (0, 2)], "no volume"),
        ([(0, 0), (1, 0)], "no volume"),
        (7, "expected pairs"),
        ([(n, 1) for n in range(2001)], "2 to 2000"),
    ],
)
def test_what_is_no_outline_is_refused(outline, words) -> None:
    with pytest.raises(AnimationError, match=words):
        Model.from_outline(outline)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("z, r\n0, 0\n1, -1\n", "own.csv, line 3: the radius is -1"),
        ("0 0\n\n2 1 # widest\n1 1\n", "own.csv, line 4: z is 1, below"),
        ("0;0\n1;x\n", "own.csv, line 2: 'x' is not a number; expected 2 numbers"),
        ("0,0\n1,\n", "own.csv, line 2: a value is missing"),
        ("0 0\n1 2 3\n", "own.csv, line 2 has 3 numbers; expected 2, as on line 1"),
        ("0 0 0\n", "own.csv, line 1 has 3 numbers; expected 2 numbers"),
        ("0 0\n1 nan\n", "own.csv, line 2: nan is not finite"),
        ("# nothing\n", "has no numbers"),
        ("z r\n", "has no numbers"),
    ],
)
def test_errors_name_file_and_line(tmp_path, monkeypatch, capsys, text, words) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "own.csv").write_text(text, encoding="utf-8")
    assert main(["render", "--outline", "own.csv", "--frame", "0", "-o", "top.png"]) == 2
    assert words in capsys.readouterr().err
    assert not (tmp_path / "top.png").exists()


def test_a_file_that_cannot_be_read_is_named(tmp_path) -> None:
    with pytest.raises(TableError, match=r"none\.csv.* could not be read"):
        Model.from_outline(tmp_path / "none.csv")
    (tmp_path / "bytes").write_bytes(b"\xff\xfe\x00")
    with pytest.raises(TableError, match="UTF-8"):
        Model.from_outline(tmp_path / "bytes")


def test_a_file_may_have_a_heading_comments_and_any_separator(tmp_path) -> None:
    for text in ("z,r\n0,0\n1.5,1\n3,0\n", "0 0\n1.5\t1\n3 0", "\ufeff# cm\n0;0\n1.5;1\n3;0\n"):
        (tmp_path / "own.txt").write_text(text, encoding="utf-8")
        assert Model.from_outline(tmp_path / "own.txt").profile == ((0, 0), (1, 1.5), (0, 3))


def test_a_cone_has_the_moments_of_a_cone() -> None:
    body = Body.turned(Model.from_outline([(0, 0), (3, 2)]).profile, scale=1.0, density=2.0)
    mass = 2 * pi * 4  # πr²h/3 times the density
    assert body.mass == pytest.approx(mass)
    assert body.height == pytest.approx(9 / 4)
    assert body.axial == pytest.approx(0.3 * mass * 4)
    assert body.transverse == pytest.approx(mass * (0.15 * 4 + 0.6 * 9))


def test_a_cylinder_has_the_moments_of_a_cylinder_and_cannot_lean() -> None:
    body = Body.turned(Model.from_outline([(0, 2), (3, 2)]).profile, scale=0.1, mass=5.0)
    assert (body.height, body.reach) == (pytest.approx(0.15), 0)
    assert body.axial == pytest.approx(5 * 0.04 / 2)
    assert body.transverse == pytest.approx(5 * (0.04 / 4 + 0.09 / 3))
    with pytest.raises(AnimationError, match="the rim is on the ground at 0°"):
        physical(body=body)


def test_a_sphere_has_the_moments_of_a_sphere() -> None:
    angles = np.linspace(-pi / 2, pi / 2, 2000)
    radii = np.cos(angles)
    radii[[0, -1]] = 0
    model = Model.from_outline(np.column_stack([1 + np.sin(angles), radii]), ring=12)
    body = Body.turned(model.profile, scale=1.0, density=3.0)
    mass = 4 * pi
    assert body.mass == pytest.approx(mass, rel=1e-5)
    assert body.height == pytest.approx(1)
    assert body.axial == pytest.approx(0.4 * mass, rel=1e-5)
    assert body.transverse == pytest.approx(1.4 * mass, rel=1e-5)
    assert len(body.outline) < 60  # the ground needs few of its corners


def test_an_outline_with_fewer_points_stays_near_all_of_them() -> None:
    z = np.linspace(0, 3, 301)
    profile = tuple((float(r), float(h)) for r, h in zip(np.sin(z * pi / 3), z, strict=True))
    few = np.array(simplified(profile, 0.01))
    assert 8 < len(few) < 30
    off = np.interp(z, few[:, 1], few[:, 0]) - np.sin(z * pi / 3)
    assert abs(off).max() < 0.015


def test_the_story_of_the_thesis_top_is_the_usual_one() -> None:
    launch, contact = story_of(Body.turned(Model().profile), True)
    assert launch.spin == pytest.approx(STORY[0].spin)
    assert (launch.tilt, contact) == (STORY[0].tilt, STORY[1])


@pytest.mark.parametrize("model", ["free", "physics", "product"])
def test_the_command_draws_an_outline_in_every_motion(tmp_path, model) -> None:
    (tmp_path / "own.csv").write_text("0,0\n12,25\n13,3\n30,2\n", encoding="utf-8")
    out = tmp_path / "top.png"
    words = ["--outline", str(tmp_path / "own.csv"), "--model", model, "--frame", "3"]
    assert main(["render", *words, "--frames", "5", "--size", "64x48", "-o", str(out)]) == 0
    assert out.stat().st_size > 100


def test_p2_is_not_for_another_outline(tmp_path, capsys) -> None:
    (tmp_path / "own.csv").write_text("0,0\n1,1\n", encoding="utf-8")
    words = ["--outline", str(tmp_path / "own.csv"), "--p2", "third"]
    assert main(["render", *words, "-o", str(tmp_path / "top.png")]) == 2
    assert "--p2 belongs to the thesis's top" in capsys.readouterr().err
