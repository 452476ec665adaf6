"""Names that stand for rings, and what is said where one stands for none.

The file has the names to try; ``python -m tests.fields.words`` writes the answers anew.
"""

import json
from pathlib import Path

from hfield.errors import HFieldError
from hfield.fields.names import ring

FILE = Path(__file__).with_name("ring_names.json")


def named(text: str) -> str:
    """Return the name of the ring that a text stands for, or what is said against it."""
    try:
        return ring(text).name
    except HFieldError as error:
        return f"{type(error).__name__}: {error}"


if __name__ == "__main__":
    found = {text: named(text) for text in json.loads(FILE.read_text(encoding="utf-8"))}
    FILE.write_text(json.dumps(found, ensure_ascii=False, indent=1) + "\n", encoding="utf-8")
