"""What a ring of the prover and one of the checker say of themselves, compared with the facts."""

from collections.abc import Callable, Iterator
from typing import Any

from hfield.checker.rejection import Rejected
from hfield.errors import UndecidedError
from tests.adversary.names.facts import ASKED, Facts


def prover_contradicts(R: Any, known: Facts) -> Iterator[str]:
    """Yield what the prover's ring says that is not so."""
    yield from _differ("the characteristic", R.characteristic, known.characteristic)
    yield from _differ("the order", R.order, known.order)
    if known.degree is not None:
        yield from _differ("the degree", getattr(R, "degree", known.degree), known.degree)
    for n, square in zip(ASKED, known.squares, strict=True):
        if square is not None:
            found = answer(lambda n=n: _is_square(R, n), UndecidedError, square)
            yield from _differ(f"whether {n} is a square", found, square)
    for text in (*known.zero, *known.nonzero):
        yield from _differ(f"whether {text} is 0", R.is_zero(R(text)), _is_zero(text, known))
    for text, sign in known.signs:
        yield from _differ(f"the sign of {text}", R.sign(R(text)), sign)
    if known.residues is not None:
        yield from _differ("the residue field", R.residues.order, known.residues)
    for text in (*known.within, *known.units):
        order = R.order_of(R(text).value)
        yield from _differ(f"whether {text} has a valuation", order > 0, text in known.within)
        yield from _differ(f"the valuation of {text}", order < 0, False)


def checker_contradicts(C: Any, known: Facts) -> Iterator[str]:
    """Yield what the checker's ring says that is not so."""
    yield from _differ("the characteristic", C.characteristic, known.characteristic)
    yield from _differ("the order", C.order, known.order)
    yield from _differ("the degree", getattr(C, "degree", known.degree), known.degree)
    for n, square in zip(ASKED, known.squares, strict=True):
        if square is not None:
            found = answer(lambda n=n: C.is_square(C.number(n)), Rejected, square)
            yield from _differ(f"whether {n} is a square", found, square)
    for text in (*known.zero, *known.nonzero):
        yield from _differ(f"whether {text} is 0", C.is_zero(C.read(text)), _is_zero(text, known))
    for text, sign in known.signs:
        yield from _differ(f"the sign of {text}", C.sign(C.read(text)), sign)
    if known.residues is not None:
        place = C.only
        inert = type(place).__name__ == "InertNumber"
        count = place.residues.order if hasattr(place, "residues") else place.n ** (1 + inert)
        yield from _differ("the residue field", count, known.residues)
        for text in (*known.within, *known.units):
            residue = place.residue(C.read(text))
            found = residue is not None and place.is_unit(residue)
            yield from _differ(f"whether {text} is a unit", found, text in known.units)


def answer(question: Callable[[], Any], silent: type[Exception], otherwise: Any) -> Any:
    """Return an answer, something else where none is given."""
    try:
        return question()
    except silent:
        return otherwise


def _is_square(R: Any, n: int) -> bool:
    return bool(R.is_square(R(n)))


def _is_zero(text: str, known: Facts) -> bool:
    """Tell whether a relation holds; a number may be 0 in the ring though it is not in all of its kind."""
    p = known.characteristic
    return text in known.zero or bool(p and text.isdigit() and int(text) % p == 0)


def _differ(what: str, found: object, fact: object) -> Iterator[str]:
    if found != fact:
        yield f"{what}: {found}, and not {fact}"
