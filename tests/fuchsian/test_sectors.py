"""Domains around points that units fix: sectors, their sides, angles and certificates."""

import cmath
import math
from itertools import pairwise
from pathlib import Path

import pytest

from hfield import QuaternionAlgebra, check, ring
from hfield.checker.check import Rejected
from hfield.core.factorisation import factorise
from hfield.fuchsian.group import Domain, NormOneGroup, signature_of
from tests.subcases import subcases


def group(D: int, N: int = 1) -> NormOneGroup:
    A = QuaternionAlgebra.from_ramification("QQ", list(factorise(D)) if D > 1 else [])
    return A.eichler_order(N).norm_one_group()


def triangle_group() -> NormOneGroup:
    K = ring("QQ[s]/(s^3+s^2-2*s-1)")
    return (
        QuaternionAlgebra.from_ramification(K, K.real_places()[:2]).maximal_order().norm_one_group()
    )


def need_sector(D: Domain, m: int) -> None:
    """The two sides at the centre enclose 2π/m, the generator maps one to the other, the area is right."""
    G, g, one = D.group, D.stabiliser, D.group.order.algebra(1)
    assert (D.sides[0].element, D.sides[0].partner) == (g, len(D.sides) - 1)
    assert g in G.order
    assert g.norm() == 1
    assert g * D.center_element == D.center_element * g
    assert [n for n in range(1, m + 1) if g**n in (one, -one)] == [m]
    assert D.vertices[0] == 0
    first, last = D.vertices[1], D.vertices[-1]
    assert cmath.phase(last / first) % math.tau == pytest.approx(math.tau / m)
    assert abs(first) == pytest.approx(abs(last))
    turns = [cmath.phase(z / first) % math.tau for z in D.vertices[2:]]
    assert all(x < y for x, y in pairwise([0.0, *turns]))
    assert D.area == G.area
    assert signature_of(D.partners, D.cycles, D.area) == G.signature
    for n, side in enumerate(D.sides):
        other = D.sides[side.partner]
        assert other.partner == n
        assert side.element * other.element in (one, -one)
    assert check(D.certificate).verdict == "proved"


@subcases("D, N", [(6, 1), (6, 5), (10, 1), (1, 1), (1, 7), (1, 13)])
def test_sectors_are_domains(D: int, N: int) -> None:
    G = group(D, N)
    points = [(point, m) for d, m in ((-3, 3), (-4, 2)) for point in G.cm_points(d)]
    assert points
    for point, m in points:
        need_sector(G.domain(point), m)


def test_a_sector_over_a_cubic_field() -> None:
    G = triangle_group()
    for d, m, sides in ((-3, 3, 3), (-4, 2, 4), ("s^2-4", 7, 3)):
        (point,) = G.cm_points(d)
        D = G.domain(point)
        need_sector(D, m)
        assert len(D.sides) == sides


def test_points_move_into_a_sector() -> None:
    G = group(6)
    polygon = G.domain(G.cm_points(-3)[0]).polygon
    for point in (*G.cm_points(-19), *G.cm_points(-4)):
        for g in (*G.generators, G.evaluate((1, 2, -1, 3))):
            v = polygon.plane.vector(g * point.root * g.inverse())
            x, path = polygon.reduced(v if v[0] > 0 else tuple(-c for c in v))
            assert polygon.beyond(x) is None
            assert len(path) < 100


def test_a_free_point_has_no_stabiliser() -> None:
    G = group(6)
    assert G.domain(G.cm_points(-24)[0]).stabiliser == 1
    assert G.domain().stabiliser == 1


def test_a_point_of_another_group_has_the_stabiliser_of_this_one() -> None:
    """An elliptic point of the maximal order is none of its suborder of level 5, and the other way around."""
    O = QuaternionAlgebra(6).maximal_order()
    G, smaller = O.norm_one_group(), O.algebra.order([2 * q for q in O.basis]).norm_one_group()
    point = G.cm_points(-4)[0]
    assert G.domain(smaller.cm_points(-16)[0]).stabiliser ** 2 in (-1, 1)
    D = smaller.domain(point)
    assert D.stabiliser == 1
    assert D.area == smaller.area


def test_false_sectors_are_refused() -> None:
    G = group(6)
    D = G.domain(G.cm_points(-3)[0])
    genuine = D.certificate
    g, units = D.stabiliser, list(D.polygon.units)
    parts = genuine["statement"][len("dirichlet-domain{") : -1].split(";")

    def stated(chosen: list) -> dict:
        texts = " | ".join(",".join(str(c) for c in u.coordinates) for u in chosen)
        return {**genuine, "statement": f"dirichlet-domain{{{parts[0]};{parts[1]}; {texts}}}"}

    assert check(stated(units)).verdict == "proved"
    for false in (
        units[::-1],  # turning the other way
        units[1:-1],  # without the rotation
        [g, *units[1:-1], g],  # no inverse
        [*units[:1], units[2], units[1], *units[3:]],
        [*units[:1], *(u * g for u in units[1:-1]), *units[-1:]],  # leaves the sector
        [*units[:1], *(g * u for u in units[1:-1]), *units[-1:]],  # another sector, not paired
        [*units[:1], *units[1:-1], *(g * u for u in units[1:-1]), *units[-1:]],
    ):
        with pytest.raises(Rejected):
            check(stated(false))


def test_sectors_are_drawn(tmp_path: Path) -> None:
    G = triangle_group()
    D = G.domain(G.cm_points("s^2-4")[0])
    D.draw(tmp_path / "sector.svg", depth=1)
    text = (tmp_path / "sector.svg").read_text(encoding="utf-8")
    assert "3 sides" in text
    assert ">a⁻¹</text>" in text
