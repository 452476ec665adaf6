"""Notebook display of rotations and rigid motions: a table of the first few."""

from __future__ import annotations

from html import escape

import numpy as np

from rotation.array_types import Array
from rotation.namespaces import is_numpy, namespace
from rotation.vectors import to_axis_angle

ROWS = 6


def table(q: Array, t: Array | None = None) -> str | None:
    """Return unit quaternions (…, 4) and translations (…, 3) as an HTML table; None unless they are numpy
    arrays.

    >>> "120°" in table(np.full(4, 0.5))
    True
    """
    if not is_numpy(namespace(q)):
        return None  # a notebook then takes the repr
    rows = q.reshape(-1, 4)[:ROWS]
    axes, angles = to_axis_angle(rows, degrees=True)
    heads = ["", "angle", "axis", "quaternion w, x, y, z"]
    columns = [
        [f"{angle:.6g}°" for angle in angles],
        [_numbers(axis) for axis in axes],
        [_numbers(row) for row in rows],
    ]
    if t is not None:
        heads.append("translation")
        columns.append(
            [_numbers(row) for row in np.broadcast_to(t, (*q.shape[:-1], 3)).reshape(-1, 3)[:ROWS]]
        )
    lines = [_row("th", heads)]
    lines += [_row("td", [str(n), *cells]) for n, cells in enumerate(zip(*columns, strict=True))]
    more = q.size // 4 - len(rows)
    shape = (
        "" if q.ndim == 1 else f"<p>shape {q.shape[:-1]}{f', and {more} more' if more else ''}</p>"
    )
    return f"<table>{''.join(lines)}</table>{shape}"


def _row(tag: str, cells: list[str]) -> str:
    return "<tr>" + "".join(f"<{tag}>{escape(cell)}</{tag}>" for cell in cells) + "</tr>"


def _numbers(values: Array) -> str:
    return ", ".join(f"{round(x, 12) + 0.0:.5g}" for x in values.tolist())
