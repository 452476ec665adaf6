"""Evidence of implications for Coq: items with their cofactors, and hints to find what they speak of."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from hfield.coq.cofactors import MismatchError, Reader, written
from hfield.coq.consequences import (
    Item,
    are_products,
    proportional,
    quotient,
    tops,
    vanishes_as_function,
)
from hfield.coq.formulas import Formula
from hfield.coq.numerators import Numerators
from hfield.coq.terms import NotCoveredError, Terms

if TYPE_CHECKING:
    import flint


@dataclass(frozen=True)
class ItemsInCoq:
    """The items of one proof for Coq."""

    items: tuple[str, ...] = ()
    numbers: tuple[int, ...] = ()
    stripped: tuple[str, ...] = ()
    vanishing: tuple[str, ...] = ()

    def __str__(self) -> str:
        numbers = "; ".join(f"({n})" for n in self.numbers)
        lists = [_list(self.items), f"[{numbers}]", _list(self.stripped), _list(self.vanishing)]
        return "Evidence\n  " + "\n  ".join(lists)


def _list(parts: Iterable[str]) -> str:
    return "[" + ";\n   ".join(parts) + "]"


class Items:
    """The items of one implication, in the variables of its statement."""

    def __init__(self, terms: Terms, data: Sequence[Mapping[str, Any]]) -> None:
        self.terms = terms
        self.reader = Reader(terms.numerators)
        self.items = [self._item(raw) for raw in data]

    def _item(self, raw: Mapping[str, Any]) -> Item:
        if raw.get("relations"):
            raise NotCoveredError("the evidence uses relations between constants of the field")
        item = Item(raw, [self.reader.value(z) for z in raw["zero"]])
        if "member" in raw:
            item.member = self.reader.value(raw["member"])
            item.denominators = {_integer(raw["denominator"])}
        else:
            item.nonzeros = [self.reader.value(g) for g in raw["nonzero"]]
            item.denominators = set(_denominators(raw["steps"]))
        return item

    def coq(self, item: Item) -> str:
        """Return an item for Coq."""
        raw = item.raw
        zeros = self._texts(self.reader, raw["zero"])
        if item.is_direct:
            member = self.reader.coq(raw["member"])
            cofactors = self._texts(self.reader, raw["cofactors"])
            _same_length(raw["cofactors"], raw["zero"])
            return f"Direct {zeros} ({member}) {cofactors} ({_integer(raw['denominator'])})"
        nonzeros = self._texts(self.reader, raw["nonzero"])
        k = len(raw["nonzero"])
        inverses = (f"T{n}" for n in range(1, k + 1))
        reader = Reader(Numerators([*inverses, *self.terms.numerators.atoms]))
        known = len(raw["zero"]) + k
        return f"Excluded {zeros} {nonzeros}\n   ({self._steps(reader, raw['steps'], known)})"

    def _texts(self, reader: Reader, texts: Sequence[str]) -> str:
        return "[" + "; ".join(reader.coq(t) for t in texts) + "]"

    def _steps(self, reader: Reader, steps: Sequence[Mapping[str, Any]], known: int) -> str:
        if not steps:
            raise MismatchError("a list of steps is empty")
        step, rest = steps[0], steps[1:]
        kind = step["step"]
        cofactors = self._texts(reader, step["cofactors"])
        _same_length(step["cofactors"], range(known))
        if (kind in ("contradiction", "cases", "no root")) != (not rest):
            raise MismatchError("the steps do not end in a contradiction, or go on after it")
        d = f"({_integer(step['denominator'])})"
        match kind:
            case "contradiction":
                return f"Contradiction {cofactors} {d}"
            case "norm":
                if "algebra" in step:
                    raise NotCoveredError("the norm form of another algebra than the statement's")
                terms = " ".join(f"({reader.coq(t)})" for t in step["terms"])
                if len(step["terms"]) != 4:
                    raise MismatchError("the norm is that of four terms")
                after = self._steps(reader, rest, known + 4)
                return f"Norm_is_zero (Quaternion {terms}) {cofactors} ({after})"
            case "squares":
                pairs = zip(step["coefficients"], step["terms"], strict=True)
                terms = "; ".join(f"(({_integer(c)})%Z, {reader.coq(t)})" for c, t in pairs)
                after = self._steps(reader, rest, known + len(step["terms"]))
                return f"Squares_are_zero [{terms}] {cofactors} ({after})"
            case "cases":
                pairs = zip(step["factors"], step["powers"], strict=True)
                factors = "; ".join(f"({reader.coq(f)}, {_integer(n)}%nat)" for f, n in pairs)
                branches = "; ".join(self._steps(reader, b, known + 1) for b in step["branches"])
                if len(step["branches"]) != len(step["factors"]):
                    raise MismatchError("factors and branches are not equally many")
                return f"Cases [{factors}] {cofactors} {d} [{branches}]"
        raise NotCoveredError(f"steps of the kind {kind!r}")

    # --- hints -----------------------------------------------------------------------------------

    def hints(self, formulas: Iterable[Formula], items: Sequence[Item], p: int) -> ItemsInCoq:
        """Return the items for Coq, with hints where it would not see by itself what they say."""
        numerators = self.terms.numerators
        found = {str(f): f for f in tops(formulas)}.values()
        stripped = {}
        for z in (z for item in items for z in (*item.zeros, *item.nonzeros, item.member)):
            if z is None or z == 0 or any(proportional(f, z) for f in found):
                continue
            for f in found:
                common = f.gcd(z) if f != 0 else f
                if common == 0 or not are_products(f, z, common, numerators.factors):
                    continue
                for h in (f, z):
                    divisors = quotient(h, common, numerators.factors)
                    if divisors:
                        ds = "; ".join(written(d) for d in divisors)
                        stripped[str(h), str(common)] = f"({written(h)}, [{ds}], {written(common)})"
        vanishing = []
        if p:
            for f in found:
                cofactors = vanishes_as_function(f, p)
                if cofactors is not None:
                    texts = "; ".join(written(c) for c in cofactors)
                    vanishing.append(f"({written(f)}, [{texts}])")
        return ItemsInCoq(
            tuple(self.coq(item) for item in items), (), tuple(stripped.values()), tuple(vanishing)
        )


def facts_used(items: Iterable[Mapping[str, Any]]) -> set[str]:
    """Return which rules of the field the steps of some items use."""
    found: set[str] = set()
    left = [step for item in items for step in item.get("steps", ())]
    while left:
        step = left.pop()
        found.add(step["step"])
        left += [inner for branch in step.get("branches", ()) for inner in branch]
    return found


def _integer(value: object) -> int:
    if not isinstance(value, int) or isinstance(value, bool):
        raise MismatchError(f"{value!r} is no integer")
    return value


def _denominators(steps: Any) -> Iterable[int]:
    for step in steps:
        yield _integer(step["denominator"])
        for branch in step.get("branches", ()):
            yield from _denominators(branch)


def _same_length(cofactors: Sequence[object], known: Sequence[flint.fmpz_mpoly]) -> None:
    if len(cofactors) != len(known):
        raise MismatchError(f"there are {len(cofactors)} cofactors for {len(known)} polynomials")
