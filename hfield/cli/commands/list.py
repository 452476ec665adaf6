"""``hfield list``: list the elements of an algebra with a property."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from collections.abc import Iterator
from itertools import islice
from typing import TYPE_CHECKING

from hfield.cli.output import Sink, open_output
from hfield.cli.parser import UsageError, add_format, add_output, suggest, whole

if TYPE_CHECKING:
    from hfield.algebra import QuaternionAlgebra
    from hfield.exploring.elements import Elements

HELP = (
    "List the elements of an algebra over a finite ring: units, zero-divisors, idempotents, nilpotents, "
    "norm=N, trace=S; or its left-ideals, right-ideals, two-sided-ideals, subalgebras, classes. Over an "
    "infinite field, random elements are printed."
)
DOING = "listing"
EXAMPLES = (
    "hfield list 'H(GF(7))' zero-divisors",
    "hfield list GF7 zero-divisors --count",
    "hfield list 'H(GF(3))' norm=1 --format csv -o units.csv",
    "hfield list GF3 left-ideals",
)
SETS = ("units", "zero-divisors", "idempotents", "nilpotents")
VALUES = ("norm", "trace")
OTHERS = ("left-ideals", "right-ideals", "two-sided-ideals", "subalgebras", "classes")
DRAWN = 10  # elements of an infinite set
MAX_LISTED = 10**9
BLOCK = 10_000  # elements that are written at a time


def configure(parser: ArgumentParser) -> None:
    """Declare the arguments."""
    parser.add_argument("algebra", metavar="ALGEBRA", help="an algebra or a field F, for H(F)")
    parser.add_argument(
        "what", metavar="WHAT", help=f"{', '.join((*SETS, 'norm=N', 'trace=S', *OTHERS))}"
    )
    parser.add_argument("--count", action="store_true", help="print only their number")
    most = whole(1, MAX_LISTED)
    parser.add_argument("--limit", type=most, metavar="N", help="list only the first N")
    add_format(parser, "plain", "csv", "json")
    add_output(parser)


def run(args: Namespace) -> int:
    """Find the elements and print them."""
    if args.algebra in (*SETS, *OTHERS):
        raise UsageError(f"the algebra comes first: write hfield list {args.what} {args.algebra}")
    from hfield.cli.parser import algebra_of

    A = algebra_of(Namespace(where=args.algebra, algebra=None, field=None))
    with open_output(args.output) as out:
        if args.what in OTHERS:
            _write_others(out, A, args)
        else:
            _write_elements(out, collection(A, args.what), args)
    return 0


def collection(A: QuaternionAlgebra, what: str) -> Elements:
    """Return the collection named on the command line. Raises :class:`UsageError`."""
    name, equals, value = what.partition("=")
    if what in SETS:
        found: Elements = getattr(A, what.replace("-", "_"))()
        return found
    if equals and name in VALUES:
        return A.elements_of_norm(value) if name == "norm" else A.elements_of_trace(value)
    known = (*SETS, *(f"{name}=1" for name in VALUES), *OTHERS)
    hint = suggest(what, known) or f"expected {', '.join(known)}"
    raise UsageError(f"there is no list of {what!r}: {hint}")


def _write_elements(out: Sink, found: Elements, args: Namespace) -> None:
    A, F = found.algebra, found.algebra.ring
    if args.count:
        total = found.cardinality()
        if args.format == "json":
            out.write_json({**_head(args), "count": total, "formula": found.formula})
        elif args.format == "csv":
            out.write(f"count,formula\n{total},{found.formula or ''}")
        else:
            out.write(
                f"{total} = {found.formula}"
                if found.formula not in (None, str(total))
                else f"{total}"
            )
        return
    elements = iter(found) if found.is_finite else iter(found.sample(args.limit or DRAWN))
    listed = islice(elements, args.limit)
    if args.format == "json":
        texts = [str(q) for q in listed]
        count = found.cardinality() if found.is_finite else None
        out.write_json({**_head(args), "count": count, "formula": found.formula, "elements": texts})
        return
    if args.format == "csv":
        out.write("1,i,j,k,trace,norm")
        lines: Iterator[str] = (
            ",".join(F.text(x) for x in (*q.coordinates, q.trace(), q.norm())) for q in listed
        )
    else:
        if not found.is_finite:
            out.write(f"# {found.condition}; random elements, since {A} is infinite")
        lines = map(str, listed)
    while block := list(islice(lines, BLOCK)):
        out.write("\n".join(block))


def _head(args: Namespace) -> dict[str, object]:
    return {"schema": "hfield-list/1", "algebra": args.algebra, "what": args.what}


def _write_others(out: Sink, A: QuaternionAlgebra, args: Namespace) -> None:
    names, rows = _rows(A, args.what)
    shown = rows[: args.limit]
    if args.count:
        shown = [[str(len(rows))]]
        names = ["count"]
    if args.format == "json":
        records = [dict(zip(names, row, strict=True)) for row in shown]
        out.write_json({**_head(args), "count": len(rows), "found": [] if args.count else records})
    elif args.format == "csv":
        import csv
        from io import StringIO

        text = StringIO()
        csv.writer(text, lineterminator="\n").writerows([names, *shown])
        out.write(text.getvalue())
    elif args.count:
        out.write(str(len(rows)))
    else:
        from hfield.presenting import aligned

        out.write("\n".join(line.rstrip() for line in aligned([names, *shown], "<" * len(names))))


def _rows(A: QuaternionAlgebra, what: str) -> tuple[list[str], list[list[str]]]:
    """Return the columns and rows of a table of ideals, subalgebras or classes."""
    if what == "classes":
        classes = A.conjugacy_classes()
        rows = [[str(c.representative), str(len(c)), str(c.minimal_polynomial)] for c in classes]
        return ["representative", "elements", "minimal polynomial"], rows
    if what == "subalgebras":
        found = [s for dimension in (1, 2, 3, 4) for s in A.subalgebras(dimension=dimension)]
        rows = [
            [str(s.dimension), s.kind, str(len(s.conjugates)), "; ".join(map(str, s.basis))]
            for s in found
        ]
        return ["dimension", "kind", "conjugates", "basis"], rows
    ideals = getattr(A, what.replace("-", "_"))()
    over_field = A.ring.is_field
    rows = [
        [
            str(ideal.dimension if over_field else ideal.cardinality()),
            "none" if ideal.generator is None else str(ideal.generator),
            "; ".join(map(str, ideal.basis)),
        ]
        for ideal in ideals
    ]
    return ["dimension" if over_field else "elements", "generator", "basis"], rows
