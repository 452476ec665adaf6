"""``hfield precompile``: compile the loops over arrays ahead of time and cache them on disk."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from collections.abc import Iterator
from time import monotonic
from typing import TYPE_CHECKING

from hfield.cli.output import open_output
from hfield.cli.parser import add_format, add_output, algebra_of

if TYPE_CHECKING:
    from hfield.algebra import QuaternionAlgebra

HELP = (
    "Compile the loops over arrays ahead of time and keep them on disk; otherwise first use "
    "compiles them. Without arguments: the loops of the usual rings."
)
DOING = "compiling"
EXAMPLES = ("hfield precompile", "hfield precompile 'H(GF(2^8))' '(-1,-3|QQ)'")
RINGS = (
    *("GF(2)", "GF(3)", "GF(4)", "GF(5)", "GF(7)", "GF(8)", "GF(9)", "GF(13)", "GF(16)", "GF(25)"),
    *("GF(27)", "GF(2^8)", "GF(3^5)", "GF(257)", "GF(65537)", "GF(2^16)", "GF(2^32)", "GF(2^64)"),
    *("ZZ/4", "ZZ/6", "ZZ", "QQ"),
)


def configure(parser: ArgumentParser) -> None:
    """Declare the arguments."""
    parser.add_argument(
        "algebras",
        metavar="A",
        nargs="*",
        help="an algebra or a ring, such as '(-1,-3|QQ)' or GF(5^3)",
    )
    add_format(parser, "plain", "json")
    add_output(parser)


def run(args: Namespace) -> int:
    """Compile the loops of each ring, and report the times."""
    from hfield.compiling.machine_code import available

    named = [algebra_of(Namespace(where=text, algebra=None, field=None)) for text in args.algebras]
    algebras = named or [A for name in RINGS for A in _usual(name)]
    took: dict[str, float] = {}
    with open_output(args.output) as out:
        for A in algebras if available() else []:
            start = monotonic()
            A.array_storage.prepare()
            took[A.name] = round(monotonic() - start, 2)
            if args.format == "plain":
                out.write(f"{A.name}: {took[A.name]:.2f} s")
        if args.format == "json":
            out.write_json(
                {"schema": "hfield-precompile/1", "compiler": available(), "seconds": took}
            )
        elif not available():
            out.write("there is no LLVM here (llvmlite is missing): arrays are computed by numpy")
    return 0


def _usual(name: str) -> Iterator[QuaternionAlgebra]:
    """Yield the algebras whose compiled loops cover nearly all others: H, (a,b|F) and, if 2 = 0, [a,b|F).

    Over finite rings the loops read the structure constants at run time, unless they are 0, 1 or −1.
    """
    from hfield.algebra import H, QuaternionAlgebra

    A = H(name)
    yield A
    F = A.ring
    if F.order is not None and F.order > 3:
        other = next(x for x in F.elements() if not any(F.equal(x, F(n)) for n in (0, 1, -1)))
        yield QuaternionAlgebra(F, other, other, int(F.characteristic == 2))
