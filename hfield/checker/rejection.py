"""The checker's one error, and helpers that reject unknown JSON data."""

from collections.abc import Mapping
from typing import NoReturn

MAX_DIGITS = 4_000
MAX_LIST = 20_000


class Rejected(Exception):  # noqa: N818  it is a verdict, not a failure
    """The certificate does not establish what it states; the message says where it fails.

    >>> from hfield import check
    >>> check({})
    Traceback (most recent call last):
    hfield.checker.rejection.Rejected: the schema must be 'hfield-cert/2'
    """


def reject(why: str) -> NoReturn:
    """Raise :class:`Rejected`."""
    raise Rejected(why)


def shown(value: object, limit: int = 60) -> str:
    """Write a value for a message, cut to ``limit`` characters."""
    if isinstance(value, int) and value.bit_length() > 3 * MAX_DIGITS:
        return f"a number of {value.bit_length()} bits"
    try:
        text = value if isinstance(value, str) else repr(value)[: 4 * limit]
    except ValueError:  # Python writes no numbers of more than 4300 digits
        text = "a number that is too long to be shown"
    text = "".join(c if c.isprintable() else "?" for c in text[: 4 * limit])
    return text if len(text) <= limit else text[: limit - 1] + "…"


def one_line(text: str) -> str:
    """Write a whole text on one line, without invisible characters."""
    return "".join(c if c.isprintable() else "?" for c in " ".join(text.split()))


def keyed(value: object, what: str = "the evidence") -> Mapping[str, object]:
    """Return a JSON object with any keys."""
    if not isinstance(value, dict):
        reject(f"{what} must be an object, found {shown(value)}")
    return value


def an_object(value: object, keys: str, what: str, optional: str = "") -> Mapping[str, object]:
    """Return a JSON object with exactly these keys (``optional`` ones may be missing)."""
    found = keyed(value, what)
    wanted, allowed = set(keys.split()), {*keys.split(), *optional.split()}
    for key in found:
        if key not in allowed:
            reject(f"{what} has an unknown key {shown(key)!r}")
    for key in sorted(wanted):
        if key not in found:
            reject(f"{what} lacks the key {key!r}")
    return found


def kind_of(evidence: object) -> str:
    """Return the kind of evidence."""
    kind = keyed(evidence).get("kind")
    if not isinstance(kind, str):
        reject("the evidence must be an object with a text 'kind'")
    return kind


def a_list(value: object, what: str, least: int = 0) -> list[object]:
    """Return a JSON list of at least ``least`` entries."""
    if not isinstance(value, list):
        reject(f"{what} must be a list, found {shown(value)}")
    if not least <= len(value) <= MAX_LIST:
        reject(f"{what} has {len(value)} entries; expected {least} to {MAX_LIST}")
    return value


def a_text(value: object, what: str, longest: int = 20_000) -> str:
    """Return a JSON string."""
    if not isinstance(value, str):
        reject(f"{what} must be a text, found {shown(value)}")
    if len(value) > longest:
        reject(f"{what} has {len(value)} characters, more than the {longest} that are read")
    return value


def an_integer(value: object, what: str, least: int | None = None) -> int:
    """Return a JSON integer (no bool, no float)."""
    if not isinstance(value, int) or isinstance(value, bool):
        reject(f"{what} must be an integer, found {shown(value)}")
    if value.bit_length() > 10 * MAX_DIGITS // 3:
        reject(f"{what} has more than {MAX_DIGITS} digits")
    if least is not None and value < least:
        reject(f"{what} must be at least {least}, found {shown(value)}")
    return value


def texts(value: object, what: str, least: int = 0) -> list[str]:
    """Return a JSON list of strings."""
    return [a_text(x, f"an entry of {what}") for x in a_list(value, what, least)]
