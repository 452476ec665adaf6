"""``hfield upgrade``: rewrite certificates of the first schema in the current one."""

from __future__ import annotations

import re
from argparse import ArgumentParser, Namespace
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from hfield.checker.check import check
from hfield.checker.first_schema import FIRST_SCHEMA, upgraded
from hfield.checker.glossary import SCHEMA
from hfield.checker.json_text import MAX_BYTES, read_json
from hfield.checker.rejection import Rejected
from hfield.cli.output import note, open_output
from hfield.cli.parser import UsageError, add_output
from hfield.errors import HFieldError, RingError, shorten
from hfield.fields.names import ring, ring_of_data
from hfield.ledger.certificate import write_certificate

HELP = (
    f"Rewrite certificates of the schema {FIRST_SCHEMA} in the schema {SCHEMA}, which states "
    "rings and places as data instead of names. Each new certificate is checked, and the "
    "field it is about is printed. Exit status: 0 all were written and are accepted; 1 some "
    "are not; 2 bad usage or an unreadable file."
)
DOING = "rewriting certificates"
EXAMPLES = ("hfield upgrade lemma.json -o lemma-2.json", "hfield upgrade old/*.json --into new")


def configure(parser: ArgumentParser) -> None:
    """Declare the arguments."""
    parser.add_argument("files", nargs="+", metavar="FILE", help=f"certificates, {FIRST_SCHEMA}")
    parser.add_argument(
        "--into", metavar="DIR", help="write the results to this directory, under the same names"
    )
    add_output(parser)


def run(args: Namespace) -> int:
    """Write each certificate in the current schema; return the exit status."""
    if args.into is None and len(args.files) > 1:
        raise UsageError("several files are written to a directory: give --into DIR")
    if args.into is not None:
        Path(args.into).mkdir(parents=True, exist_ok=True)
    status = 0
    for name in args.files:
        try:
            data = _upgraded(name)
        except (OSError, UnicodeDecodeError) as error:
            reason = getattr(error, "strerror", None) or error
            raise UsageError(f"cannot read {shorten(name)!r}: {reason}") from None
        except (HFieldError, Rejected) as error:
            note(f"{name}: nothing is written: {error}")
            status = 1
            continue
        if args.into is None:
            with open_output(args.output) as out:
                out.write_json(data)
        else:
            write_certificate(Path(args.into) / Path(name).name, data)
        words = "all fields" if data["ring"] is None else ring_of_data(data["ring"]).in_words()
        try:
            note(f"{name}: {str(check(data)).splitlines()[0]}; {words}")
        except Rejected as error:
            note(f"{name}: rejected: {error}")
            status = 1
    return status


def _upgraded(name: str) -> dict[str, object]:
    with Path(name).open("rb") as stream:
        data = read_json(stream.read(MAX_BYTES + 1).decode())
    if not isinstance(data, dict) or data.get("schema") != FIRST_SCHEMA:
        raise RingError(f"this is not a certificate {FIRST_SCHEMA}")
    out = upgraded(data, _ring, _place)
    if out["ring"] is not None:
        old, out["field"] = str(out["field"]), ring_of_data(out["ring"]).name
        out = _over(out, f"|{old})", f"|{out['field']})")
    return out


def _over(value: Any, old: str, new: str) -> Any:
    """Rewrite algebras with the new spelling of their field."""
    if isinstance(value, list):
        return [_over(x, old, new) for x in value]
    if not isinstance(value, dict):
        return value
    return {
        key: x.replace(old, new) if key == "algebra" else _over(x, old, new)
        for key, x in value.items()
    }


def _ring(name: str) -> Mapping[str, object]:
    data = ring(name).data
    if data is None:
        raise RingError(f"{name} has no data that a certificate can carry")
    return data


def _place(text: str, data: Mapping[str, object] | None) -> Mapping[str, object]:
    """Read a place in the notation of the first schema. Raises :class:`HFieldError`."""
    from hfield.fields.quadratic_forms.global_field import known_field

    if data is None:
        raise RingError("a place of no field")
    field: Any = ring_of_data(data)
    if text.strip().isdecimal() and data["kind"] in ("rationals", "quadratic field"):
        return {"kind": "number", "n": int(text)}
    blank = "".join(text.split())
    m = re.fullmatch(r"\(([0-9]+),(.*)-([0-9]+)\)", blank)
    if m and data["kind"] == "quadratic field" and m[2] == field.gen_name:
        return {"kind": "split", "n": int(m[1]), "root": int(m[3])}
    m = re.fullmatch(r"\(([0-9]+),([^;]+);(.+)\)", blank)
    if m and data["kind"] == "number field":
        g = ring("ZZ[x]")(m[2]).to_dict()
        polynomial = [int(g.get((n,), 0)) for n in range(max(g)[0] + 1)]
        generator = field.coordinates(field(m[3]))
        return {
            "kind": "other generator",
            "p": int(m[1]),
            "polynomial": polynomial,
            "generator": generator,
        }
    found: Mapping[str, object] = field.place_data(known_field(field).read_place(text))
    return found
