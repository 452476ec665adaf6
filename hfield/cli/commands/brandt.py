"""``hfield brandt``: Brandt matrices, Hecke polynomials, and the graph of p-neighbours."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from collections.abc import Iterator, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from hfield.cli.answer_formats import OutputDocument, answer_one
from hfield.cli.order_arguments import (
    SECONDS_A_CLASS,
    add_class_search,
    algebra_of,
    announce,
    class_search,
    ideal_json,
    level_of,
    unit_numbers,
)
from hfield.cli.output import OutputError, gone_on, try_picture
from hfield.cli.parser import UsageError, add_factors, add_format, add_output, given_factors
from hfield.cli.status import Waiting
from hfield.core.files import whole_file
from hfield.errors import shorten

if TYPE_CHECKING:
    from concurrent.futures import Executor

    from hfield.algebra.quaternion_algebra import QuaternionAlgebra
    from hfield.cli.commands.brandt_graph import BrandtGraph
    from hfield.ledger.claims_table import TerminalStyle
    from hfield.orders.base_values import BaseIdeal
    from hfield.orders.lattice import ClassSet

HELP = (
    "Print a Brandt matrix for discriminant D and level N with its characteristic "
    "polynomial, or the edges of its graph in the format of "
    "networkx.read_weighted_edgelist. For a prime D and level 1 the graph is the "
    "supersingular isogeny graph."
)
DOING = "enumerating classes"
EXAMPLES = (
    "hfield brandt 11 --prime 2",
    "hfield brandt '(-1,-1|QQ(sqrt(5)))' '6 + sqrt(5)' --prime 'sqrt(5)'",
)
MAX_DRAWN_CLASSES = 600


def configure(parser: ArgumentParser) -> None:
    """Declare the arguments."""
    parser.add_argument("algebra", metavar="D", help="a discriminant such as 11, or an algebra")
    parser.add_argument("level", metavar="N", nargs="?", default="1", help="the level (default: 1)")
    parser.add_argument(
        "--prime",
        metavar="N",
        help="index of the matrix: a prime or any N ≥ 1; over a number field, an ideal (default: 2, "
        "over GF(q)(t) the variable)",
    )
    parser.add_argument("--plot", metavar="FILE", help="draw the graph to FILE (.svg, .png, .pdf)")
    parser.add_argument("--dark", action="store_true", help="draw the graph on a dark page")
    add_class_search(parser)
    add_factors(parser)
    add_format(parser, "plain", "json", "latex", "edges")
    add_output(parser)


def run(args: Namespace) -> int:
    """Compute the matrix, and print it."""
    with given_factors(args), class_search(args) as executor:
        return answer_one(args, partial(_answer, args, executor))


def _default_prime(A: QuaternionAlgebra) -> str:
    """Return 2, or the variable of a field of functions."""
    return A.ring.gen_name or "2" if A.ring.characteristic else "2"


def _answer(args: Namespace, executor: Executor | None) -> OutputDocument:
    from hfield.orders.mass_formula import class_number_by_formula

    replace = bool(args.plot) and try_picture(args.plot)
    A = algebra_of(args.algebra)
    n = level_of(args.prime or _default_prime(A), A, "index")
    O = A.eichler_order(level_of(args.level, A))
    factors = O.value.ambient.base.factorisation(n)
    is_prime = [e for _, e in factors] == [1]
    sparse = args.format == "edges" and not args.plot and is_prime
    number = class_number_by_formula(O.value) if O.is_definite() else None
    if number is not None:
        _announce(number, sparse, args.format in ("plain", "json"))
    C = O.class_set(executor=executor, file=args.resume)
    if args.plot and len(C) > MAX_DRAWN_CLASSES:
        raise UsageError(
            f"there are {len(C)} classes, and a graph of at most {MAX_DRAWN_CLASSES} vertices is drawn: "
            "--format edges lists its edges"
        )
    Waiting.at("computing neighbours" if sparse else "computing the matrix")
    rows = C.neighbour_counts(n, executor=executor) if sparse else []
    matrix = [] if sparse else C.brandt_matrix(n)
    if args.plot:
        _plot(_graph(C, matrix, n), args, replace)

    def characteristic() -> list[int]:
        Waiting.at("computing its characteristic polynomial")
        found: list[int] = C.hecke_polynomial(n)
        return found

    def data() -> dict[str, object]:
        return {
            "schema": "hfield-brandt/1",
            "algebra": str(A),
            "discriminant": ideal_json(O.value.ambient.discriminant),
            "level": ideal_json(O.level),
            "n": ideal_json(n),
            "classes": len(C),
            "units": unit_numbers(C),
            "matrix": matrix,
            "characteristic_polynomial": characteristic(),
        }

    def latex() -> str:
        rows = " \\\\\n".join(" & ".join(map(str, row)) for row in matrix)
        return f"\\begin{{pmatrix}}\n{rows}\n\\end{{pmatrix}}"

    def edges() -> str:
        found = rows if sparse else [dict(enumerate(row)) for row in matrix]
        return "\n".join(_edges(found))

    def page(style: TerminalStyle) -> str:
        return "\n".join(_plain(C, matrix, n, characteristic(), style.width))

    return OutputDocument(data, page, {"latex": latex, "edges": edges})


def _announce(number: int, sparse: bool, polynomial: bool) -> None:
    """Announce a long run and its estimated time. Raises :class:`TooLargeError` if memory is too small."""
    from hfield.orders.brandt import expect_matrix_fits

    instead = "--format edges, with a prime, writes only the entries that are not 0"
    seconds = number * SECONDS_A_CLASS
    if not sparse:
        expect_matrix_fits(number)
        seconds += number**2 * 4e-7 + (number**4 * 2e-11 if polynomial else 0)
    announce(number, seconds, "hfield classes --formula counts them" if sparse else instead)


def _edges(rows: Sequence[Mapping[int, int]]) -> Iterator[str]:
    return (f"{i} {j} {row[j]}" for i, row in enumerate(rows) for j in sorted(row) if row[j])


def _plain(
    C: ClassSet, matrix: list[list[int]], n: BaseIdeal, characteristic: list[int], width: int
) -> list[str]:
    from hfield.presenting import hanging

    wide = max(len(str(x)) for row in matrix for x in row)
    title = f"Brandt matrix of {n}, {len(C)} classes of {C.order.algebra}, level {C.order.level}"
    lines = [*gone_on(title, width).splitlines(), ""]
    lines += ["  " + " ".join(f"{x:>{wide}}" for x in row) for row in matrix]
    text = polynomial(characteristic)
    return [*lines, "", *hanging("characteristic polynomial  ", text, width)]


def polynomial(coefficients: list[int]) -> str:
    """Write a polynomial in x, the highest power first."""
    text = ""
    for e in range(len(coefficients) - 1, -1, -1):
        c = coefficients[e]
        if not c:
            continue
        power = "" if e == 0 else "x" if e == 1 else f"x^{e}"
        size = str(abs(c)) if abs(c) != 1 or not e else ""
        term = f"{size}*{power}" if size and power else size or power
        sign = "-" if c < 0 else "+"
        text += f" {sign} {term}" if text else f"{'-' if c < 0 else ''}{term}"
    return text or "0"


def _plot(graph: BrandtGraph, args: Namespace, replace: bool) -> None:
    """Draw the graph. Raises :class:`OutputError`."""
    from hfield.cli.commands.brandt_graph import draw

    try:
        with whole_file(Path(args.plot), replace) as part:
            draw(graph, part, args.dark)
    except (OSError, ValueError) as error:
        raise OutputError(
            f"cannot draw to {shorten(args.plot)!r}: {error}; try a file name that ends in .svg, .png or .pdf"
        ) from error


def _graph(C: ClassSet, matrix: list[list[int]], n: BaseIdeal) -> BrandtGraph:
    """Return the graph of a Brandt matrix."""
    from hfield.cli.commands.brandt_graph import BrandtGraph
    from hfield.core.primality import is_prime

    O, units = C.order, unit_numbers(C)
    p = O.discriminant()
    if isinstance(p, int) and is_prime(p):
        title = f"Isogenies of degree {n} between supersingular curves in characteristic {p}"
        return BrandtGraph(matrix, units, title, "isogenies", C.exchanged(p))
    discriminant = O.value.ambient.discriminant
    title = f"Brandt graph of {n} in {O.algebra}, discriminant {discriminant}, level {O.level}"
    return BrandtGraph(matrix, units, title)
