"""All eyes distinguish the colours of paired sides; letters say which unit lies beyond a side."""

from functools import cache
from itertools import combinations

import numpy as np
import pytest

from hfield import QuaternionAlgebra
from hfield.fuchsian.group import Domain
from hfield.fuchsian.page import page
from hfield.fuchsian.pair_colors import (
    DARK,
    DARK_PAIRS,
    LIGHT,
    LIGHT_PAIRS,
    letter,
    letters,
    pair_numbers,
    shade,
)
from hfield.fuchsian.picture import drawing_of, letters_on_sides, svg
from hfield.fuchsian.search import Sight
from hfield.fuchsian.tessellation import move

# Machado, Oliveira and Fernandes, IEEE TVCG 15 (2009), severity 1, on linear sRGB.
EYES = {
    "trichromat": np.eye(3),
    "deuteranope": np.array(
        [
            [0.367322, 0.860646, -0.227968],
            [0.280085, 0.672501, 0.047413],
            [-0.011820, 0.042940, 0.968881],
        ]
    ),
    "protanope": np.array(
        [
            [0.152286, 1.052583, -0.204868],
            [0.114503, 0.786281, 0.099216],
            [-0.003882, -0.048116, 1.051998],
        ]
    ),
}
TO_XYZ = np.array(
    [
        [0.4124564, 0.3575761, 0.1804375],
        [0.2126729, 0.7151522, 0.0721750],
        [0.0193339, 0.1191920, 0.9503041],
    ]
)


def linear(color: str) -> np.ndarray:
    channels = np.array([int(color[n : n + 2], 16) / 255 for n in (1, 3, 5)])
    return np.where(channels <= 0.04045, channels / 12.92, ((channels + 0.055) / 1.055) ** 2.4)


def lab(channels: np.ndarray) -> np.ndarray:
    x = TO_XYZ @ np.clip(channels, 0, 1) / [0.95047, 1, 1.08883]
    x = np.where(x > (6 / 29) ** 3, np.cbrt(x), x / (3 * (6 / 29) ** 2) + 4 / 29)
    return np.array([116 * x[1] - 16, 500 * (x[0] - x[1]), 200 * (x[1] - x[2])])


def difference(one: np.ndarray, other: np.ndarray) -> float:
    """ΔE₀₀ of two colours in CIELAB, after Sharma, Wu and Dalal (2005)."""
    (L1, a1, b1), (L2, a2, b2) = one, other
    mean = (np.hypot(a1, b1) + np.hypot(a2, b2)) / 2
    stretch = 1.5 - 0.5 * np.sqrt(mean**7 / (mean**7 + 25.0**7))
    z1, z2 = complex(a1 * stretch, b1), complex(a2 * stretch, b2)
    c1, c2 = abs(z1), abs(z2)
    h1, h2 = (np.degrees(np.angle(z)) % 360 for z in (z1, z2))
    turn = (h2 - h1 + 180) % 360 - 180
    c, h, L = (c1 + c2) / 2, (h1 + turn / 2) % 360, (L1 + L2) / 2
    t = 1 - 0.17 * np.cos(np.radians(h - 30)) + 0.24 * np.cos(np.radians(2 * h))
    t += 0.32 * np.cos(np.radians(3 * h + 6)) - 0.2 * np.cos(np.radians(4 * h - 63))
    light = (L2 - L1) / (1 + 0.015 * (L - 50) ** 2 / np.sqrt(20 + (L - 50) ** 2))
    chroma = (c2 - c1) / (1 + 0.045 * c)
    hue = 2 * np.sqrt(c1 * c2) * np.sin(np.radians(turn / 2)) / (1 + 0.015 * c * t)
    crossed = (
        -2
        * np.sqrt(c**7 / (c**7 + 25.0**7))
        * np.sin(np.radians(60 * np.exp(-(((h - 275) / 25) ** 2))))
    )
    return float(np.sqrt(light**2 + chroma**2 + hue**2 + crossed * chroma * hue))


@pytest.mark.parametrize(
    ("one", "other", "expected"),
    [  # of the table of Sharma, Wu and Dalal
        ((50, 2.6772, -79.7751), (50, 0, -82.7485), 2.0425),
        ((50, 2.5, 0), (73, 25, -18), 27.1492),
        ((22.7233, 20.0904, -46.6940), (23.0331, 14.9730, -42.5619), 2.0373),
        ((90.8027, -2.0831, 1.4410), (91.1528, -1.6435, 0.0447), 1.4441),
    ],
)
def test_the_difference_of_colours_is_that_of_the_standard(one, other, expected) -> None:
    assert difference(np.array(one), np.array(other)) == pytest.approx(expected, abs=1e-4)


@pytest.mark.parametrize("eyes", EYES)
@pytest.mark.parametrize("pairs", [LIGHT_PAIRS, DARK_PAIRS], ids=["light", "dark"])
def test_ten_pairs_are_distinguished(pairs, eyes) -> None:
    assert len(set(pairs)) == 10
    seen = [lab(EYES[eyes] @ linear(color)) for color in pairs]
    assert min(difference(one, other) for one, other in combinations(seen, 2)) >= 15


@pytest.mark.parametrize(("pairs", "theme"), [(LIGHT_PAIRS, LIGHT), (DARK_PAIRS, DARK)])
def test_sides_stand_out_from_the_domain(pairs, theme) -> None:
    ground = TO_XYZ[1] @ linear(theme["domain"]) + 0.05
    for color in pairs:
        ratio = (TO_XYZ[1] @ linear(color) + 0.05) / ground
        assert max(ratio, 1 / ratio) >= 3


def test_images_fade_towards_the_disc() -> None:
    assert shade(0, 0, False) == shade(10, 0, False) == LIGHT_PAIRS[0]
    ground = linear(DARK["disc"])
    away = [np.abs(linear(shade(1, n, True)) - ground).sum() for n in range(9)]
    assert away == sorted(away, reverse=True)


@cache
def domain(discriminant: int) -> Domain:
    return QuaternionAlgebra(discriminant).maximal_order().norm_one_group().domain()


def test_letters_name_pairs() -> None:
    assert [letter(n) for n in (0, 25, 26, 53)] == ["a", "z", "a₁", "b₂"]
    D = domain(6)
    names = letters(D.partners, pair_numbers(D))
    for n, p in enumerate(D.partners):
        assert {names[n], names[p]} == (
            {names[n]} if n == p else {names[min(n, p)], names[min(n, p)] + "⁻¹"}
        )


@pytest.mark.parametrize("discriminant", [6, 26])
def test_a_unit_maps_the_side_of_its_inverse_to_its_own(discriminant: int) -> None:
    D = domain(discriminant)
    rows = np.array(D.group.order.rows(D.polygon.units), float)
    corners = np.array(D.vertices)
    for n, (a, b) in enumerate(zip(*Sight(D.polygon.plane).motions(rows), strict=True)):
        p = D.partners[n]
        moved = move(a, b, corners[[p, (p + 1) % len(corners)]])
        assert moved == pytest.approx(corners[[(n + 1) % len(corners), n]], abs=1e-8)


def test_letters_stand_inside_the_domain_by_their_sides() -> None:
    D = domain(26)
    drawing = drawing_of(D, False, None)
    placed = list(letters_on_sides(drawing))
    assert [text for _, _, text in placed] == drawing.letters
    for (place, size, _), side in zip(placed, drawing.own, strict=True):
        chord = side.end - side.start
        inwards = ((place / 320 - side.start) / chord).imag * abs(chord) * 320
        assert inwards > size / 2
        assert abs(place / 320) < 1
    picture = svg(D)
    assert all(f">{text}</text>" in picture for text in drawing.letters)


def test_a_page_begins_dark_on_request() -> None:
    assert 'data-look="dark"' in page(domain(6), dark=True)
    assert 'data-look="system"' in page(domain(6))
