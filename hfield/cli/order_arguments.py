"""Arguments and certificates shared by the commands about orders, ideals and classes."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

from hfield.cli.answer_formats import OutputDocument, answer_one
from hfield.cli.output import OutputError, note, open_output
from hfield.cli.parser import (
    UsageError,
    add_factors,
    add_format,
    add_jobs,
    add_output,
    add_standalone,
    given_factors,
)
from hfield.errors import shorten
from hfield.syntax.brackets import split

if TYPE_CHECKING:
    from concurrent.futures import Executor

    from hfield.algebra import QuaternionAlgebra
    from hfield.algebra.quaternion import Quaternion
    from hfield.evidence import CertifiedClaim
    from hfield.orders.base_values import BaseIdeal
    from hfield.orders.lattice import ClassSet, Ideal, Lattice
    from hfield.verdicts import Verdict

PATIENCE = 10
"""Seconds: a command that takes longer prints an estimate first."""

SECONDS_A_CLASS = 5e-4
"""How long it takes to find a class, and its type."""


def add_answers(parser: ArgumentParser) -> None:
    """Declare the options --certificate, --factors, --format and --output."""
    parser.add_argument("--certificate", metavar="FILE", help="write the certificate to FILE")
    add_factors(parser)
    add_format(parser, "plain", "json", "latex")
    add_standalone(parser)
    add_output(parser)


def answer_certified(
    args: Namespace,
    answer: Callable[
        [Namespace], tuple[OutputDocument, Callable[[], CertifiedClaim | Verdict[Any]]]
    ],
) -> int:
    """Answer the command, with the primes of --factors, and write a certificate with --certificate."""
    with given_factors(args), open_output(args.certificate) as file:

        def certified() -> OutputDocument:
            found, claim = answer(args)
            if args.certificate is not None:
                claimed = claim()
                if claimed.certificate is None:
                    note(f"no certificate is written: {claimed.why_no_certificate}")
                else:
                    file.write_json(claimed.certificate)
            return found

        return answer_one(args, certified)


def add_class_search(parser: ArgumentParser) -> None:
    """Declare the options --jobs and --resume of a search for classes."""
    parser.add_argument(
        "--resume",
        metavar="FILE",
        help="keep classes and neighbours in FILE (JSON lines); an interrupted run continues from it",
    )
    add_jobs(parser, "use the Dask cluster at ADDRESS")


@contextmanager
def class_search(args: Namespace) -> Iterator[Executor | None]:
    """Yield the executor for a search of classes, or None to search in this process.

    Raises :class:`OutputError` where the file cannot be written.
    """
    from hfield.core.executors import open_executor

    size = _size(args.resume)
    try:
        if args.jobs == 1 and args.dask is None:
            yield None
        else:
            with open_executor(args.jobs, args.dask) as executor:
                yield executor
    except KeyboardInterrupt:
        if _size(args.resume) > size:
            note(f"the same command goes on from {args.resume}")
        raise
    except OSError as error:
        if args.resume is None or error.filename != args.resume:
            raise
        reason = error.strerror or str(error)
        raise OutputError(f"cannot write {shorten(args.resume)!r}: {reason}") from error


def _size(path: str | None) -> int:
    """Return the size of a file in bytes, 0 if it does not exist."""
    return Path(path).stat().st_size if path is not None and Path(path).exists() else 0


def add_algebra(parser: ArgumentParser) -> None:
    """Declare the algebra argument."""
    parser.add_argument(
        "algebra",
        metavar="ALGEBRA",
        help="such as '(-1,-11|QQ)' or '(-1,-1|QQ(sqrt(5)))', or a discriminant such as 11 or 30",
    )


def add_where(parser: ArgumentParser) -> None:
    """Declare the algebra and level arguments."""
    add_algebra(parser)
    parser.add_argument(
        "--level",
        metavar="N",
        default="1",
        help="the level, prime to the discriminant: a number, or generators such as '11, 4 + sqrt(5)'",
    )


def algebra_of(text: str) -> QuaternionAlgebra:
    """Read an algebra, or a discriminant over ℚ. Raises :class:`RingError`."""
    from hfield.algebra import QuaternionAlgebra

    return QuaternionAlgebra(text)


def announce(number: int, seconds: float, instead: str) -> None:
    """Announce a long enumeration: the number of classes, the time, and the alternative."""
    from hfield.orders.classes import MAX_CLASSES

    if seconds < PATIENCE or number > MAX_CLASSES:  # more are refused at once
        return
    units = {"days": 86_400, "hours": 3_600, "minutes": 60, "seconds": 1}
    unit = next(unit for unit, size in units.items() if seconds >= 1.5 * size or size == 1)
    note(
        f"there are {number} classes, by Eichler's formula, and this takes about "
        f"{round(seconds / units[unit])} {unit}; {instead}"
    )


def elements_of(A: QuaternionAlgebra, text: str, what: str) -> list[Quaternion]:
    """Read elements separated by commas. Raises :class:`UsageError` if there is none."""
    words = [word for word in split(text, ",") if word.strip()]
    if not words:
        raise UsageError(f"{what} names no element; expected elements such as 'i, j'")
    return [A(word) for word in words]


def level_of(text: str, A: QuaternionAlgebra, what: str = "level") -> BaseIdeal:
    """Read a level: a positive integer over ℚ, or comma-separated generators of an ideal over another field.

    Ideals as hfield prints them, such as ``ideal(31, 5 + gen)``, are read too. Raises :class:`LatticeError`.
    """
    from hfield.orders.basis import basis_of

    return basis_of(A).base.integral_ideal(text, what)


def summands(L: Lattice) -> list[tuple[str, str]]:
    """Return the pairs of a pseudo-basis, an ideal and an element, as texts."""
    base = L.value.ambient.base
    return [(str(base.ideal(list(ideal))), str(q)) for ideal, q in L.pseudo_basis()]


def lattice_data(L: Lattice) -> dict[str, object]:
    """Return a lattice as JSON data: rows, and a pseudo-basis if a basis has more than four elements."""
    from hfield.orders.lattice_values import rows_json

    pairs = {} if len(L.basis) == 4 else {"pseudo_basis": summands(L)}
    return {**rows_json(L.value), **pairs}


def class_data(ideal: Ideal) -> dict[str, object]:
    """Return the JSON data of an ideal that represents its class."""
    return {**lattice_data(ideal), "norm": ideal_json(ideal.norm())}


def unit_numbers(C: ClassSet) -> list[int]:
    """Return the numbers of units by class, modulo the units of the field if they are infinite."""
    from hfield.errors import NotFiniteError

    try:
        return C.unit_counts
    except NotFiniteError:
        return C.units


def unit_groups(C: ClassSet) -> Iterator[str]:
    """Yield, for each class, the name of the unit group of the left order."""
    known: dict[int, str] = {}
    for ideal, index, kind in zip(C, C.units, C.types, strict=True):
        # if the only units are those of the field, the groups are isomorphic
        key = kind if index > 1 else -1
        if key not in known:
            known[key] = ideal.left_order().unit_group()
        yield known[key]


def basis_name(L: Lattice) -> str:
    """Return a lattice as text: a basis of four elements, or a sum of ideals times elements."""
    return "basis" if len(L.basis) == 4 else "sum of"


def basis_text(L: Lattice) -> str:
    """Return a basis of four elements, or the lattice as the sum of ideals times elements."""
    if len(L.basis) == 4:
        return ", ".join(map(str, L.basis))
    return " + ".join(
        f"({q})" if ideal == "ideal(1)" else f"{ideal}·({q})" for ideal, q in summands(L)
    )


def ideal_json(ideal: Any, number: Callable[[Any], object] = int) -> object:
    """Return generators, the absolute norm and the prime factors of an ideal.

    For ℤ the result is the generator: an int, or ``number`` of it if it may be a fraction.
    """
    if not hasattr(ideal, "generators"):
        return number(ideal)
    return {
        "generators": [ideal.ring.text(x) for x in ideal.generators],
        "norm": str(ideal.norm()),
        "factorisation": [[str(P), e] for P, e in ideal.factorisation()],
    }
