"""Evidence of implications for Coq."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from flint.utils.flint_exceptions import DomainError

from hfield.export.coq.certificate_data import ItemData, StepData
from hfield.export.coq.cofactors import MismatchError, Numerators, written
from hfield.export.coq.formulas import Equation, Formula, Junction, equations
from hfield.export.coq.terms import NotCoveredError, Terms

if TYPE_CHECKING:
    import flint


@dataclass
class CertificateItem:
    """One item of the certificate, with its polynomials."""

    raw: ItemData
    zeros: list[flint.fmpz_mpoly]
    member: flint.fmpz_mpoly | None = None
    nonzeros: list[flint.fmpz_mpoly] = field(default_factory=list)
    denominators: set[int] = field(default_factory=set)

    @property
    def is_direct(self) -> bool:
        """Whether the item is also valid over rings that are not fields."""
        return self.member is not None

    @property
    def characteristic(self) -> int:
        """The characteristic in which the item holds, 0 for all characteristics."""
        return int(self.raw["characteristic"])


def tops(formulas: Iterable[Formula]) -> list[flint.fmpz_mpoly]:
    """Return the numerators of all differences in some formulas."""
    out = []
    for equation in (e for f in formulas for e in equations(f)):
        out += differences(equation)
    return out


def differences(equation: Equation) -> list[flint.fmpz_mpoly]:
    """Return the numerators of the differences of both sides."""
    left, right = equation.left, equation.right
    if left.is_scalar:
        return [(left.scalar - right.scalar).top]
    pairs = zip(left.coordinates, right.coordinates, strict=True)
    return [(u - v).top for u, v in pairs]


def proportional(f: flint.fmpz_mpoly, g: flint.fmpz_mpoly) -> bool:
    """Return whether two polynomials are proportional, with a number as factor."""
    if f == 0 or g == 0:
        return bool(f == g)
    return bool(g.leading_coefficient() * f == f.leading_coefficient() * g)


def are_products(
    f: flint.fmpz_mpoly,
    z: flint.fmpz_mpoly,
    common: flint.fmpz_mpoly,
    factors: Sequence[flint.fmpz_mpoly],
) -> bool:
    """Return whether f and z are ``common`` times products of denominators."""
    parts = [proportional(h, common) or bool(quotient(h, common, factors)) for h in (f, z)]
    return all(parts)


def quotient(
    f: flint.fmpz_mpoly, z: flint.fmpz_mpoly, factors: Sequence[flint.fmpz_mpoly]
) -> list[flint.fmpz_mpoly]:
    """Return factors with product f/z, up to a constant; empty if there are none."""
    if f == 0 or z == 0:
        return []
    content = z.content()
    try:
        rest = (f * content) / z
    except DomainError:
        return []
    out = []
    for d in factors:
        while not d.is_constant() and not rest.is_constant():
            try:
                rest = rest / d
            except DomainError:
                break
            out.append(d)
    return out if rest.is_constant() else []


def vanishes_as_function(f: flint.fmpz_mpoly, p: int) -> list[flint.fmpz_mpoly] | None:
    """Return polynomials, one for each variable x, by which x^p - x is multiplied to sum to f, if f is 0 on
    GF(p).
    """
    context = f.context()
    width = context.nvars()
    current = {m: int(c) % p for m, c in f.to_dict().items() if int(c) % p}
    if not current or all(max(m) < p for m in current):
        return None
    cofactors = []
    for n in range(width):
        out: dict[tuple[int, ...], int] = {}
        cofactor: dict[tuple[int, ...], int] = {}
        for m, c in current.items():
            e = m[n]
            while e >= p:  # x^e = x^(e-p)·(x^p - x) + x^(e-p+1)
                low = (*m[:n], e - p, *m[n + 1 :])
                cofactor[low] = cofactor.get(low, 0) + c
                e -= p - 1
            own = (*m[:n], e, *m[n + 1 :])
            out[own] = (out.get(own, 0) + c) % p
        current = {m: c for m, c in out.items() if c}
        cofactors.append(context.from_dict({m: c % p for m, c in cofactor.items() if c % p}))
    return None if current else cofactors


# --- what holds over every commutative ring --------------------------------------------------------


class Directly:
    """A derivation of a formula over commutative rings as Coq makes it; it predicts whether Coq succeeds."""

    def __init__(self, items: Sequence[CertificateItem]) -> None:
        self.items = [i for i in items if i.is_direct]

    def derives(self, zeros: Sequence[flint.fmpz_mpoly], formula: Formula) -> bool:
        """Return whether the formula follows if these polynomials are 0."""
        match formula:
            case Equation():
                return all(self._zero(zeros, f) for f in differences(formula))
            case Junction("and", left, right):
                return self.derives(zeros, left) and self.derives(zeros, right)
            case Junction("or", left, right):
                return self.derives(zeros, left) or self.derives(zeros, right)
            case Junction("=>", left, right):
                cases = self._cases(left)
                return cases is not None and all(
                    self.derives([*more, *zeros], right) for more in cases
                )
            case Junction("<=>", left, right):
                there, back = Junction("=>", left, right), Junction("=>", right, left)
                return self.derives(zeros, there) and self.derives(zeros, back)
        return False

    def _zero(self, zeros: Sequence[flint.fmpz_mpoly], f: flint.fmpz_mpoly) -> bool:
        if f == 0 or any(_opposite(f, z) for z in zeros) or any(_is_one(z) for z in zeros):
            return True
        return any(
            all(z == 0 or any(_opposite(z, y) for y in zeros) for z in i.zeros)
            and (_opposite(i.member, f) or _is_one(i.member))
            for i in self.items
        )

    def _cases(self, formula: Formula) -> list[list[flint.fmpz_mpoly]] | None:
        match formula:
            case Equation():
                return [differences(formula)]
            case Junction("and" | "or" as op, left, right):
                first, second = self._cases(left), self._cases(right)
                if first is None or second is None:
                    return None
                if op == "or":
                    return first + second
                return [u + v for u in first for v in second]
        return None


def is_positive(formula: Formula) -> bool:
    """Return whether Coq can derive a formula without deciding whether two elements are equal."""
    match formula:
        case Equation():
            return True
        case Junction("and" | "or", left, right):
            return is_positive(left) and is_positive(right)
        case Junction("=>", left, right):
            return has_cases(left) and is_positive(right)
        case Junction("<=>", left, right):
            return has_cases(left) and has_cases(right)
    return False


def has_cases(formula: Formula) -> bool:
    """Return whether a hypothesis is a disjunction of systems of equations."""
    match formula:
        case Equation():
            return True
        case Junction("and" | "or", left, right):
            return has_cases(left) and has_cases(right)
    return False


def _is_one(f: flint.fmpz_mpoly) -> bool:
    return bool(f in (1, -1))


def _opposite(f: flint.fmpz_mpoly, g: flint.fmpz_mpoly) -> bool:
    return bool(f in (g, -g))


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

    def __init__(self, terms: Terms, data: Sequence[ItemData]) -> None:
        self.terms = terms
        self.items = [self._item(raw) for raw in data]

    def _item(self, raw: ItemData) -> CertificateItem:
        if raw.get("relations"):
            raise NotCoveredError("the evidence uses relations between constants of the field")
        read = self.terms.numerators.read
        item = CertificateItem(raw, [read(z) for z in raw["zero"]])
        if "member" in raw:
            item.member = read(raw["member"])
            item.denominators = {_integer(raw["denominator"])}
        else:
            item.nonzeros = [read(g) for g in raw["nonzero"]]
            item.denominators = set(_denominators(raw["steps"]))
        return item

    def coq(self, item: CertificateItem) -> str:
        """Return an item for Coq."""
        raw, known = item.raw, self.terms.numerators
        zeros = _texts(known, raw["zero"])
        if item.is_direct:
            member = known.coq(raw["member"])
            cofactors = _texts(known, raw["cofactors"])
            _same_length(raw["cofactors"], raw["zero"])
            return f"Direct {zeros} ({member}) {cofactors} ({_integer(raw['denominator'])})"
        nonzeros = _texts(known, raw["nonzero"])
        k = len(raw["nonzero"])
        inverses = (f"T{n}" for n in range(1, k + 1))
        wider = Numerators([*inverses, *known.atoms])
        steps = _steps(wider, raw["steps"], len(raw["zero"]) + k)
        return f"Excluded {zeros} {nonzeros}\n   ({steps})"

    # --- hints -----------------------------------------------------------------------------------

    def hints(
        self, formulas: Iterable[Formula], items: Sequence[CertificateItem], p: int
    ) -> ItemsInCoq:
        """Return the items for Coq, with hints that Coq needs."""
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


def _texts(names: Numerators, texts: Sequence[str]) -> str:
    """Return polynomials as a Coq list."""
    return "[" + "; ".join(map(names.coq, texts)) + "]"


def _steps(names: Numerators, steps: Sequence[StepData], known: int) -> str:
    """Return the steps of a proof by contradiction in Coq; ``known`` polynomials vanish before the first
    step.
    """
    if not steps:
        raise MismatchError("a list of steps is empty")
    step, rest = steps[0], steps[1:]
    kind = step["step"]
    cofactors = _texts(names, step["cofactors"])
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
            terms = " ".join(f"({names.coq(t)})" for t in step["terms"])
            if len(step["terms"]) != 4:
                raise MismatchError("the norm is that of four terms")
            after = _steps(names, rest, known + 4)
            return f"Norm_is_zero (Quaternion {terms}) {cofactors} ({after})"
        case "squares":
            pairs = zip(step["coefficients"], step["terms"], strict=True)
            terms = "; ".join(f"(({_integer(c)})%Z, {names.coq(t)})" for c, t in pairs)
            after = _steps(names, rest, known + len(step["terms"]))
            return f"Squares_are_zero [{terms}] {cofactors} ({after})"
        case "cases":
            divisors = zip(step["factors"], step["powers"], strict=True)
            factors = "; ".join(f"({names.coq(f)}, {_integer(n)}%nat)" for f, n in divisors)
            branches = "; ".join(_steps(names, b, known + 1) for b in step["branches"])
            if len(step["branches"]) != len(step["factors"]):
                raise MismatchError("factors and branches are not equally many")
            return f"Cases [{factors}] {cofactors} {d} [{branches}]"
    raise NotCoveredError(f"steps of the kind {kind!r}")


def facts_used(items: Iterable[ItemData]) -> set[str]:
    """Return the field axioms that the steps of some items use."""
    found: set[str] = set()
    left = [step for item in items for step in item.get("steps", ())]
    while left:
        step = left.pop()
        found.add(step["step"])
        left += [inner for branch in step.get("branches", ()) for inner in branch]
    return found


def _integer(value: object) -> int:
    if not isinstance(value, int) or isinstance(value, bool):
        raise MismatchError(f"{value!r} is not an integer")
    return value


def _denominators(steps: Iterable[StepData]) -> Iterable[int]:
    for step in steps:
        yield _integer(step["denominator"])
        for branch in step.get("branches", ()):
            yield from _denominators(branch)


def _same_length(cofactors: Sequence[object], known: Sequence[flint.fmpz_mpoly]) -> None:
    if len(cofactors) != len(known):
        raise MismatchError(f"there are {len(cofactors)} cofactors for {len(known)} polynomials")
