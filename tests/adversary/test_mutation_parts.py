"""What scripts/mutation.py names is there: a part without its file or its tests would look well tested."""

import importlib.util
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
SPEC = importlib.util.spec_from_file_location("mutation", ROOT / "scripts" / "mutation.py")
mutation = importlib.util.module_from_spec(SPEC)
SPEC.loader.exec_module(mutation)


@pytest.mark.parametrize("part", mutation.PARTS)
def test_every_file_named_is_there(part):
    assert [
        name for names in mutation.PARTS[part] for name in names if not any(ROOT.glob(name))
    ] == []
