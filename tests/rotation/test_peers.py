"""The table of docs/how-to/coming-from-scipy.md: what users of other libraries write here."""

import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import rotation

PAGE = Path(__file__).parents[2] / "docs" / "how-to" / "coming-from-scipy.md"
RNG = np.random.default_rng(31)
IMPORTS = {
    "pytransform3d": "from pytransform3d.rotations import *; from pytransform3d.transformations import *",
    "quaternionic": "import quaternionic",
    "numpy-quaternion": "import quaternion",
}


def rows() -> list[tuple[str, str, str]]:
    """Library, what was written, and what is written here, of every row with one call of each."""
    found = re.findall(r"^\| ([\w-]+) `([^`]+)`[^|]*\| `([^`]+)`", PAGE.read_text(), re.MULTILINE)
    return [row for row in found if row[0] in IMPORTS]


def unit(*shape: int) -> np.ndarray:
    q = RNG.standard_normal((*shape, 4))
    return q / np.linalg.norm(q, axis=-1, keepdims=True)


def numbers(value: Any) -> np.ndarray:
    if getattr(value, "dtype", None) == "quaternion":
        return np.asarray(value).reshape(-1).view(float).reshape(*np.shape(value), 4)
    return np.asarray(value.as_quat() if hasattr(value, "as_quat") else value, float)


@pytest.mark.parametrize(("library", "theirs", "ours"), rows())
def test_both_columns_are_equal(library: str, theirs: str, ours: str) -> None:
    pytest.importorskip({"numpy-quaternion": "quaternion"}.get(library, library))
    names: dict[str, Any] = {}
    exec(IMPORTS[library], names)
    here = {name: getattr(rotation, name) for name in dir(rotation)} | {"np": np}
    turn, other = rotation.Rotation(unit()), rotation.Rotation(unit())
    moves = [
        rotation.RigidTransform.from_components(RNG.standard_normal(3), r) for r in (turn, other)
    ]
    given: dict[str, Any] = {"v": RNG.standard_normal((5, 3)), "t": 0.3}
    if library == "pytransform3d":
        p, q = (m.as_dual_quat() for m in moves)
        given |= {
            "a": np.array([0.0, 0.6, 0.8, 1.2]),
            "R": turn.as_matrix(),
            "T": moves[0].as_matrix(),
        }
        given |= {"p": p, "q": q} if "dual" in theirs else {"p": RNG.standard_normal(3)}
    elif library == "quaternionic":
        given["q"] = names["quaternionic"].array(unit(4))
    elif "slerp" in theirs:
        p, q = unit(2)
        p *= np.sign(p @ q)  # the shorter way
        given |= {n: names["quaternion"].from_float_array(c) for n, c in (("p", p), ("q", q))}
    else:
        given["q"] = names["quaternion"].from_float_array(unit(4))
    wanted, found = (
        numbers(eval(code, there | given)) for code, there in ((theirs, names), (ours, here))
    )
    if wanted.shape[-1:] in ((4,), (8,)) and wanted.ndim == 1:
        found = found * np.sign(found @ wanted)
    np.testing.assert_allclose(found, wanted.reshape(found.shape), atol=1e-12)
