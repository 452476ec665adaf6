"""``hfield classes``: the ideal classes of an Eichler order, by formula and by enumeration."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import Any

from hfield.commands.orders import (
    SECONDS_A_CLASS,
    add_answers,
    add_where,
    algebra_of,
    announce,
    level_of,
    open_answers,
    write_certificate,
)
from hfield.commands.output import fitted
from hfield.commands.parser import UsageError

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
    add_answers(parser)


def run(args: Namespace) -> int:
    """Count, enumerate unless told not to, and print."""
    if args.formula and args.certificate is not None:
        raise UsageError(
            "--certificate asks for the classes, and --formula enumerates none: leave one of them out"
        )
    with open_answers(args) as (out, file):
        A, level = algebra_of(args.algebra), level_of(args.level)
        O = A.eichler_order(level)
        number, mass = A.class_number(level), O.mass()
        if not args.formula:
            announce(number, number * SECONDS_A_CLASS, "--formula enumerates none")
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
            width = out.style().width
            if args.format == "latex":
                out.write_latex("\n".join(_latex(facts, C)), args.standalone)
            else:
                out.write("\n".join(_plain(facts, C, width)))
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


def _plain(facts: list[tuple[str, str]], C: Any, width: int) -> list[str]:
    lines = [fitted(facts, 14, width)]
    if C is None:
        return lines
    table = _table(C)
    widths = [max(len(row[n]) for row in table) for n in range(5)]
    lines.append("")
    for row in table:
        cells = "  ".join(f"{x:>{w}}" for x, w in zip(row, widths, strict=False))
        lines.append(fitted([(f"{cells} ", row[5])], len(cells) + 1, width))
    if len(C) > SHOWN:
        lines.append(f"… and {len(C) - SHOWN} more; --format json lists all")
    return lines


def _latex(facts: list[tuple[str, str]], C: Any) -> list[str]:
    from hfield.latex import descriptions, words

    lines = [descriptions((label, words(text)) for label, text in facts)]
    if C is None:
        return lines
    header, *rows = [row[:5] for row in _table(C)]
    lines += [r"\begin{tabular}{rrrlr}", " & ".join(header) + r" \\ \hline"]
    lines += [" & ".join([*row[:3], rf"$\mathrm{{{row[3]}}}$", row[4]]) + r" \\" for row in rows]
    return [*lines, r"\end{tabular}"]
