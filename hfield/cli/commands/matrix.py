"""``hfield matrix``: describe a matrix over a quaternion algebra."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from functools import partial
from typing import TYPE_CHECKING

from hfield.cli.answer_formats import OutputDocument, of_parts
from hfield.cli.batch import add_inputs, answer_all
from hfield.cli.parser import add_algebra, add_output, add_standalone, algebra_of
from hfield.errors import HFieldError, NotInvertibleError, RingError, UndecidedError

if TYPE_CHECKING:
    from collections.abc import Iterator

    from hfield.algebra import QuaternionAlgebra
    from hfield.matrices.matrix import Matrix

HELP = (
    "Compute with matrices such as '[[1,i],[j,k]]' or '[[1,i],[j,k]]^2 * 2'. The functions "
    "inv, transpose and conj apply. The result is shown with its reduced norm, rank, "
    "inverse and kernels, and with forms and eigenvalues where they exist. Inside an entry, "
    "[p,q] is a commutator."
)
DOING = "computing"
EXAMPLES = (
    "hfield matrix '[[1,i],[j,k]]'",
    "hfield matrix '[[1,i],[j,k]] * [[1,0],[i,1]]' --field GF7",
)
COLUMNS = (
    *("expression", "algebra", "field", "value", "rank", "reduced_norm"),
    *("characteristic_polynomial", "inverse", "right_kernel", "left_kernel"),
    *("diagonal_form", "signature", "right_eigenvalues", "error"),
)


def configure(parser: ArgumentParser) -> None:
    """Declare the arguments."""
    add_inputs(parser, "MATRIX", "the matrix, in quotes", "plain", "json", "latex")
    add_standalone(parser)
    add_algebra(parser)
    add_output(parser)


def run(args: Namespace) -> int:
    """Compute the result and print it."""
    return answer_all(args, partial(_answer, algebra_of(args)), COLUMNS)


def _answer(A: QuaternionAlgebra, text: str) -> OutputDocument:
    from hfield.presenting import Facts

    M = A.matrix(text)
    facts = dict(_facts(A, M))
    named = {"matrix": M.text(), "over": A.name, **facts}

    def data() -> dict[str, object]:
        known = {name.replace(" ", "_"): value for name, value in facts.items()}
        own = {"expression": text, "algebra": A.name, "field": A.ring.name, "value": M.text()}
        return {"schema": "hfield-matrix/1", **own, **known}

    formulas = {"matrix": f"${M.text('latex')}$"}
    return of_parts(data, lambda: [Facts([*named.items()], 26, formulas=formulas)])


def _facts(A: QuaternionAlgebra, M: Matrix) -> Iterator[tuple[str, str]]:
    """Yield the rows of the answer that are known."""
    F, square = A.ring, M.shape[0] == M.shape[1]
    if square:
        c = M.reduced_characteristic_polynomial()
        yield "reduced norm", F.text(c[0])
        yield "characteristic polynomial", str(A.polynomials("x")(c))
    if F.is_field and F.is_exact:
        yield "rank", str(M.rank())
    if square:
        try:
            yield "inverse", M.inverse().text()
        except NotInvertibleError as error:
            yield "inverse", f"none, for {str(error).partition(': ')[2]}"
    for name in ("right_kernel", "left_kernel"):
        try:
            found = getattr(M, name)()
        except (UndecidedError, RingError):
            continue
        if found:
            yield name.replace("_", " "), ", ".join(f"({', '.join(map(str, v))})" for v in found)
    if square and M.is_hermitian() and F.is_exact:
        try:
            d, P = M.diagonal_form()
            yield "diagonal form", f"({', '.join(map(str, d))}), by {P}"
            p, n, z = M.signature()
            yield "signature", f"{p} positive, {n} negative, {z} zero"
        except (UndecidedError, RingError):
            pass
    if square and (not F.is_exact or F.closure == "real closed"):
        try:
            values = M.right_eigenvalues()
        except HFieldError:
            return
        shown = [f"{z:.15g}" for z in values] if not F.is_exact else [str(z) for z in values]
        yield "right eigenvalues", ", ".join(shown)
