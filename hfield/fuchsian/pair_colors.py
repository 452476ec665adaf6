"""Colours and letters of paired sides, in light and dark pictures and pages."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from hfield.fuchsian.group import Domain

LIGHT = {
    "page": "#ffffff",
    "disc": "#f4f5f8",
    "ink": "#1d2433",
    "edge": "#ffffff",
    "domain": "#ffffff",
}
DARK = {
    "page": "#11141b",
    "disc": "#1a1f2a",
    "ink": "#eef1f7",
    "edge": "#11141b",
    "domain": "#1f2633",
}
LIGHT_PAIRS = (
    *("#2f6fb5", "#f36900", "#680005", "#57989f", "#955467"),
    *("#081ca3", "#5e0535", "#ae8e78", "#b63603", "#3996ff"),
)
DARK_PAIRS = (
    *("#6aa5e8", "#fff069", "#5f7d5f", "#78b4a5", "#8b6d8b"),
    *("#a5ffe1", "#2f6de6", "#a5b469", "#96e1f0", "#6c8a00"),
)
"""Any two differ by ΔE₀₀ ≥ 15, as trichromats, deuteranopes and protanopes see them (simulated as Machado,
Oliveira and Fernandes did, 2009); each has a contrast of at least 3 to the domain. Found by search."""
CM_COLORS = ("#ffc400", "#00c2a8", "#ff5fa2", "#9be22d", "#b388ff", "#ffffff")
"""Of the marks of CM points, which have a border: one colour for each discriminant."""
NEAREST_SHARE, NEXT_SHARE, GREATEST_SHARE = 0.5, 0.1, 0.9
"""The share of the disc's colour in images: next to the domain, its growth by length, and the greatest."""


def pair_numbers(domain: Domain) -> list[int]:
    """Return a number for each side, from 0, the same for both sides of a pair."""
    firsts = [min(n, p) for n, p in enumerate(domain.partners)]
    number = {first: k for k, first in enumerate(sorted(set(firsts)))}
    return [number[first] for first in firsts]


def letters(partners: Sequence[int], numbers: Sequence[int]) -> list[str]:
    """Return a letter for each side: a for the first of a pair, a⁻¹ for the second.

    The tile beyond side a is the image of the domain under the unit that maps side a⁻¹ to side a.
    """
    return [
        letter(k) + ("⁻¹" if p < n else "")
        for n, (p, k) in enumerate(zip(partners, numbers, strict=True))
    ]


def letter(number: int) -> str:
    """Return a, b, …, z, a₁, b₁, …"""
    turn, place = divmod(number, 26)
    index = str(turn).translate(str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")) if turn else ""
    return chr(ord("a") + place) + index


def shade(number: int, length: int, dark: bool) -> str:
    """Return a pair's colour for tiles whose words start with its sides; length 0 is the side itself."""
    pairs, disc = (DARK_PAIRS, DARK["disc"]) if dark else (LIGHT_PAIRS, LIGHT["disc"])
    share = min(GREATEST_SHARE, NEAREST_SHARE + NEXT_SHARE * (length - 1)) if length else 0.0
    return mixed(pairs[number % len(pairs)], disc, share)


def mixed(color: str, other: str, share: float) -> str:
    """Return a colour #rrggbb mixed with a share of another."""
    values = ((int(color[n : n + 2], 16), int(other[n : n + 2], 16)) for n in (1, 3, 5))
    return "#" + "".join(f"{round(a + (b - a) * share):02x}" for a, b in values)
