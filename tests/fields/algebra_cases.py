"""The committed vectors of other systems, see tests/vectors/README.md."""

import json
from pathlib import Path
from typing import Any

from hfield.core.product import Constants
from hfield.fields.names import ring

FOLDER = Path(__file__).parents[1] / "vectors"


def cases(name: str) -> list[dict[str, Any]]:
    return json.loads((FOLDER / f"{name}.json").read_text())["cases"]


def constants(spec: str, a: Any, t: Any, b: Any) -> Constants:
    F = ring(spec)
    return Constants(F(a), F(t), F(b))
