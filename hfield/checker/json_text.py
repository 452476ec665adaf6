"""Read JSON strictly: no repeated keys, no floats, bounded numbers and nesting."""

import json
from typing import NoReturn

from hfield.checker.budget import spend
from hfield.checker.rejection import MAX_DIGITS, reject, shown

MAX_BYTES = 8_000_000
MAX_NESTING = 120


def read_json(text: str) -> object:
    """Read JSON. Raises :class:`Rejected`."""
    if len(text) > MAX_BYTES:
        reject(f"the file has more than {MAX_BYTES} characters")
    spend(len(text) // 3)
    try:
        data = json.loads(
            text,
            object_pairs_hook=_object,
            parse_float=_no_integer,
            parse_int=_integer,
            parse_constant=_no_integer,
        )
    except (ValueError, RecursionError) as error:
        reject(f"this is not JSON: {shown(str(error), 120)}")
    level, depth = [data], 0
    while level:
        depth += 1
        if depth > MAX_NESTING:
            reject(f"the file nests deeper than {MAX_NESTING} levels")
        level = [x for value in level for x in _inside(value)]
    return data


def _inside(value: object) -> list[object]:
    if isinstance(value, dict):
        return list(value.values())
    return value if isinstance(value, list) else []


def _object(pairs: list[tuple[str, object]]) -> dict[str, object]:
    out = dict(pairs)
    if len(out) < len(pairs):
        reject("an object has the same key twice")
    return out


def _no_integer(text: str) -> NoReturn:
    reject(f"the number {shown(text)} is not an integer")


def _integer(text: str) -> int:
    if len(text) > MAX_DIGITS + 1:
        reject(f"a number has more than {MAX_DIGITS} digits")
    return int(text)
