"""``hfield classes``: the ideal classes of an Eichler order, by formula and by enumeration."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING, Any

from hfield.commands.output import Sink, note, open_output
from hfield.commands.parser import UsageError, add_format, add_output
from hfield.errors import shorten

if TYPE_CHECKING:
    from hfield.algebra import QuaternionAlgebra
    from hfield.lattices.certified import Claim

HELP = (
    "Enumerate the right ideal classes of an Eichler order of a definite algebra over QQ, compare with "
    "Eichler's class number formula and with the mass, and tell the types and the units."
)
DOING = "enumerating classes"
EXAMPLES = ("hfield classes '(-1,-11|QQ)' --level 3",)
SHOWN = 40


def configure(parser: ArgumentParser) -> None:
    """Declare the arguments."""
    add_where(parser)
    parser.add_argument("--formula", action="store_true", help="enumerate nothing")
    add_certificate(parser)
    add_format(parser, "plain", "json", "latex")
    add_output(parser)


def add_certificate(parser: ArgumentParser) -> None:
    """Declare the file for a certificate."""
    parser.add_argument("--certificate", metavar="FILE", help="write the certificate to FILE")


def write_certificate(file: Sink, claim: Claim) -> None:
    """Write a certificate, or tell why there is none."""
    if claim.certificate is None:
        note(f"no certificate is written: {claim.why_no_certificate}")
    else:
        file.write_json(claim.certificate)


def add_where(parser: ArgumentParser) -> None:
    """Declare the algebra and the level."""
    parser.add_argument(
        "algebra",
        metavar="ALGEBRA",
        help="such as '(-1,-11|QQ)', or a discriminant such as 11 or 30",
    )
    parser.add_argument(
        "--level", metavar="N", default="1", help="the level, prime to the discriminant"
    )


def algebra_of(text: str) -> QuaternionAlgebra:
    """Read an algebra, or the definite one of a discriminant. Raises :class:`UsageError`."""
    from hfield.algebra import QuaternionAlgebra
    from hfield.factorisation import factorise

    if not (text.isascii() and text.isdecimal()):
        return QuaternionAlgebra.from_text(text)
    primes = factorise(int(text)) if int(text) > 1 else {}
    if len(primes) % 2 == 0 or max(primes.values()) > 1:
        raise UsageError(
            f"{shorten(text)} is not the discriminant of a definite algebra over QQ: expected a product of "
            "an odd number of different primes, or an algebra such as '(-1,-11|QQ)'"
        )
    return QuaternionAlgebra.from_ramification("QQ", sorted(primes))


def level_of(text: str) -> int:
    """Read a level. Raises :class:`UsageError`."""
    if not (text.isascii() and text.isdecimal() and int(text) > 0):
        raise UsageError(f"the level {shorten(text)!r} is no positive integer")
    return int(text)


def run(args: Namespace) -> int:
    """Count, enumerate unless told not to, and print."""
    if args.formula and args.certificate is not None:
        raise UsageError(
            "--certificate asks for the classes, and --formula enumerates none: leave one of them out"
        )
    A, level = algebra_of(args.algebra), level_of(args.level)
    with open_output(args.output) as out, open_output(args.certificate) as file:
        O = A.eichler_order(level)
        number, mass = A.class_number(level), O.mass()
        C = None if args.formula else O.class_set()
        if C is not None and args.certificate is not None:
            write_certificate(file, C.claim)
        if args.format == "json":
            head = {
                "schema": "hfield-classes/1",
                "algebra": A.name,
                "discriminant": A.discriminant(),
                "level": level,
                "class_number": number,
                "mass": str(mass),
            }
            tail = {} if C is None else {"type_number": C.type_number, **C.evidence}
            out.write_json({**tail, **head})
        else:
            facts = [
                ("algebra", f"{A.name}, discriminant {A.discriminant()}, level {level}"),
                ("class number", f"{number}, by Eichler's formula"),
                ("mass", f"{mass}, the sum of 1/[units : ±1]"),
            ]
            if C is not None:
                facts[1] = ("class number", f"{number}, by Eichler's formula and by enumeration")
                facts.append(("type number", str(C.type_number)))
            out.write("\n".join(_latex(facts, C) if args.format == "latex" else _plain(facts, C)))
    return 0


def _table(C: Any) -> list[list[str]]:
    header = ["class", "norm", "units", "group", "type", "reduced basis"]
    rows = [header]
    for n, I in enumerate(C):
        if n == SHOWN:
            break
        O = I.left_order()
        basis = ", ".join(str(q) for q in I.reduced_basis())
        rows.append(
            [str(n), str(I.norm()), str(C.unit_counts[n]), O.unit_group(), str(C.types[n]), basis]
        )
    return rows


def _plain(facts: list[tuple[str, str]], C: Any) -> list[str]:
    lines = [f"{label:<14} {text}" for label, text in facts]
    if C is None:
        return lines
    table = _table(C)
    widths = [max(len(row[n]) for row in table) for n in range(5)]
    lines.append("")
    for row in table:
        cells = [f"{x:>{w}}" for x, w in zip(row, widths, strict=False)]
        lines.append("  ".join([*cells, row[5]]))
    if len(C) > SHOWN:
        lines.append(f"… and {len(C) - SHOWN} more; --format json lists all")
    return lines


def _latex(facts: list[tuple[str, str]], C: Any) -> list[str]:
    lines = [f"% {label}: {text}" for label, text in facts]
    if C is None:
        return lines
    header, *rows = [row[:5] for row in _table(C)]
    lines += [r"\begin{tabular}{rrrlr}", " & ".join(header) + r" \\ \hline"]
    lines += [" & ".join([*row[:3], rf"$\mathrm{{{row[3]}}}$", row[4]]) + r" \\" for row in rows]
    return [*lines, r"\end{tabular}"]
