"""Lemma 1 of the thesis (1.1.3): multilinear maps are decided on tuples of basis vectors.

The general k-linear form on V = F⁴ has an unknown entry for each basis tuple. All claims about it here are
identities between polynomials with integer coefficients; so they hold over every commutative ring, and for
maps to V coordinate by coordinate.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import lru_cache
from itertools import product as tuples
from typing import TYPE_CHECKING

from hfield.checker.glossary import (
    BASIS_TUPLES,
    EXHAUSTION,
    IDENTITY,
    INDUCTION,
    PROVED,
    REFUTED,
)
from hfield.evidence import Evidence, Kind
from hfield.fields.base.ring import Ring
from hfield.notation import BASIS
from hfield.prover.decision import COMMUTATIVE_RINGS, Decision
from hfield.prover.steps import say

if TYPE_CHECKING:
    import flint


N = len(BASIS)
Tuple = tuple[int, ...]


def all_tuples(k: int) -> tuple[Tuple, ...]:
    """Return the n^k tuples of basis vectors, as indices."""
    return tuple(tuples(range(N), repeat=k))


def constant_tuples(k: int) -> tuple[Tuple, ...]:
    """Return the n tuples that repeat one basis vector, written ``{e_{i_1}}_{i=1}^k``."""
    return tuple((n,) * k for n in range(N))


def short_tuples(k: int) -> tuple[Tuple, ...]:
    """Return the tuples in which k − 1 indices vary and the last index is that of e."""
    return tuple((*t, 0) for t in all_tuples(k - 1))


def spoilt_tuples(k: int) -> tuple[Tuple, ...]:
    """Return all tuples except the last one."""
    return all_tuples(k)[:-1]


class Form:
    """The general k-linear form: unknown entries ``h_t`` and arguments ``a1 … ak``, as polynomials.

    ``extra`` names further unknowns in the same polynomial ring.
    """

    def __init__(self, k: int, extra: tuple[str, ...] = ()) -> None:
        from flint import Ordering, fmpz_mpoly_ctx

        self.k = k
        entries = ["h" + "".join(map(str, t)) for t in all_tuples(k)]
        arguments = [f"a{m}_{n}" for m in range(k) for n in range(N)]
        names = (*entries, *arguments, *extra)
        gens = fmpz_mpoly_ctx.get(names, Ordering.lex).gens()
        self.zero = gens[0] - gens[0]
        self.one = self.zero + 1
        self.entry = dict(zip(all_tuples(k), gens, strict=False))
        coordinates = gens[len(entries) :]
        self.arguments = [list(coordinates[N * m : N * m + N]) for m in range(k)]
        self.extra = coordinates[N * k :]

    def __call__(self, *arguments: list[flint.fmpz_mpoly]) -> flint.fmpz_mpoly:
        """Return the value of the form: Σ h_t · Π a_m[t_m], summed over the last index first."""
        values = list(self.entry.values())
        for a in reversed(arguments):
            rows = range(0, len(values), N)
            values = [
                sum((h * u for h, u in zip(values[r : r + N], a, strict=True)), self.zero)
                for r in rows
            ]
        return values[0]

    def at(
        self, slot: int, vector: list[flint.fmpz_mpoly], last: list[flint.fmpz_mpoly]
    ) -> flint.fmpz_mpoly:
        """Return the value with ``vector`` in the slot, ``last`` at the end, and general arguments
        elsewhere.
        """
        arguments = [*self.arguments[:-1], last]
        arguments[slot] = vector
        return self(*arguments)

    def basis(self, n: int) -> list[flint.fmpz_mpoly]:
        """Return the n-th basis vector."""
        return [self.one if m == n else self.zero for m in range(N)]

    def monomial(self, t: Tuple) -> flint.fmpz_mpoly:
        """Return Π a_m[t_m], the monomial whose coefficient is the entry at t."""
        term = self.one
        for a, n in zip(self.arguments, t, strict=True):
            term = term * a[n]
        return term


Choice = Callable[[int], Iterable[Tuple]]
_NAMES: dict[Choice, str] = {
    all_tuples: "all",
    constant_tuples: "constant",
    short_tuples: "short",
    spoilt_tuples: "all-but-one",
}
BY_EXPANDING = Evidence(Kind.IDENTITY)


def for_every_k(core: str) -> str:
    """Return the statement for the given numbers of arguments, to be continued by induction."""
    return f"citing{{induction; {core}}}"


def _numbers(numbers: tuple[int, ...]) -> str:
    return ",".join(map(str, numbers))


def _word(t: Tuple) -> str:
    return "".join(BASIS[n] for n in t)


@lru_cache(maxsize=64)
def _determines(choice: Choice, k: int) -> bool:
    """Return whether f = g follows, over every field, if they agree on ``choice(k)``."""
    form = Form(k)
    left = form(*form.arguments)
    for t in set(choice(k)):
        # The entry at t is the value at t: agreeing there means that h_t = 0.
        value = form(*(form.basis(n) for n in t))
        left = left - value * form.monomial(t)
    return bool(left == 0)


@dataclass(frozen=True)
class DeterminedBy:
    """The claim that k-linear maps that agree on ``choice(k)`` are equal, for each k in ``arities``."""

    choice: Choice
    arities: tuple[int, ...]
    words: str
    assumes: tuple[str, ...] = ()

    @property
    def text(self) -> str:
        """The claim in words."""
        return f"k-linear f, g: Vᵏ → V are equal if and only if they agree on {self.words}"

    @property
    def statement(self) -> str:
        """The claim for these numbers of arguments, in the vocabulary of certificates."""
        core = f"determined-by{{{_NAMES[self.choice]}; {_numbers(self.arities)}}}"
        return for_every_k(core) if self.assumes else core

    def decide(self, field: Ring | None) -> Decision:
        """Set the entries h_t of f − g to 0 on the given tuples; the claim holds if f − g becomes 0."""
        steps: list[str] = []
        for k in self.arities:
            given = set(self.choice(k))
            if not _determines(self.choice, k):
                t = next(t for t in all_tuples(k) if t not in given)
                vectors = ", ".join(BASIS[n] for n in t)
                steps.append(say("left-out", k=k, t=vectors))
                witness = {
                    f"a{m}": [str(int(n == r)) for r in range(N)] for m, n in enumerate(t, 1)
                }
                witness |= {"f": ["1", "0", "0", "0"], "g": ["0", "0", "0", "0"]}
                return Decision(
                    REFUTED,
                    BASIS_TUPLES,
                    witness=witness,
                    steps=tuple(steps),
                    evidence=Evidence(Kind.LEFT_OUT, tuple=_word(t)),
                )
            steps.append(say("all-tuples", k=k, n=len(given)))
        return Decision(
            PROVED,
            BASIS_TUPLES,
            steps=tuple(steps),
            scope=COMMUTATIVE_RINGS,
            assumes=self.assumes,
            evidence=Evidence(
                Kind.BASIS_TUPLES,
                tuples=[[_word(t) for t in self.choice(k)] for k in self.arities],
            ),
        )


@dataclass(frozen=True)
class CurriedIsLinear:
    """The claim that fixing the last argument at a basis vector leaves an m-linear map; false for power 2."""

    power: int = 1

    @property
    def text(self) -> str:
        """The claim in a formula."""
        square = "" if self.power == 1 else "²"
        return (
            "f̃(a₁,…,aₘ) = f(a₁,…,aₘ,e₀) is m-linear: "
            f"f̃(…, s·a + y·b, …) = s{square}·f̃(…, a, …) + y·f̃(…, b, …)"
        )

    @property
    def statement(self) -> str:
        """The claim in the vocabulary of certificates."""
        return for_every_k(f"curried-linear{{{self.power}}}")

    def decide(self, field: Ring | None) -> Decision:
        """Expand both sides for m = 1, 2, and each slot and e₀."""
        for m in (1, 2):
            form = Form(m + 1, ("s", "y", *(f"b{n}" for n in range(N))))
            s, y, *b = form.extra
            for last, slot in tuples(range(N), range(m)):
                a, fixed = form.arguments[slot], form.basis(last)
                mixed = form.at(slot, [s * u + y * v for u, v in zip(a, b, strict=True)], fixed)
                if mixed != s**self.power * form.at(slot, a, fixed) + y * form.at(slot, b, fixed):
                    step = say("doubles")
                    witness = {"s": ["2"], "y": ["0"]}
                    refuted = Decision(REFUTED, IDENTITY, witness=witness, steps=(step,))
                    return _over_all(field, refuted)
        return _expanded(say("expand-slots"))


def _expanded(step: str) -> Decision:
    return Decision(
        PROVED,
        IDENTITY,
        steps=(step,),
        scope=COMMUTATIVE_RINGS,
        assumes=(INDUCTION,),
        evidence=BY_EXPANDING,
    )


def _over_all(field: Ring | None, decision: Decision) -> Decision:
    """Return the decision over all fields; s² − s vanishes on GF(2), as maps are compared by values."""
    if field is not None and field.order == 2:
        return Decision(PROVED, EXHAUSTION, steps=(say("two-elements"),))
    return decision


@dataclass(frozen=True)
class LastArgument:
    """The claim ``Σ_{i≤n} α_i f(…, e_i) = f(…, Σ_{i≤upper} α_i e_i)``, where V has n = 4 basis vectors."""

    upper: int = N
    arities: tuple[int, ...] = (1, 2, 3)

    @property
    def text(self) -> str:
        """The chain in a formula."""
        bound = {N: "n", N + 1: "n+1", N - 1: "n−1"}[self.upper]
        return f"Σ_{{i=1}}^n α_i g(a₁,…,aₘ,e_i) = g(a₁,…,aₘ, Σ_{{i=1}}^{{{bound}}} α_i e_i)"

    @property
    def statement(self) -> str:
        """The chain for these numbers of arguments, in the vocabulary of certificates."""
        return for_every_k(f"last-argument{{{self.upper}; {_numbers(self.arities)}}}")

    def decide(self, field: Ring | None) -> Decision:
        """Expand both sides; for a summand beyond the basis an arbitrary vector b is used."""
        for k in self.arities:
            form = Form(k, (*(f"x{n}" for n in range(N + 1)), *(f"b{n}" for n in range(N))))
            x, b = form.extra[: N + 1], form.extra[N + 1 :]
            fixed = form.arguments[: k - 1]
            vectors = [*(form.basis(n) for n in range(N)), list(b)]
            left = form.zero
            for n in range(N):
                left = left + x[n] * form(*fixed, vectors[n])
            total = [form.zero] * N
            for n in range(self.upper):
                total = [u + x[n] * v for u, v in zip(total, vectors[n], strict=True)]
            if left != form(*fixed, total):
                n = min(self.upper, N)
                step = say("summand", n=n + (self.upper > N), m=N, k=self.upper)
                witness = {f"x{m + 1}": [str(int(m == n))] for m in range(N + 1)}
                return Decision(
                    REFUTED, IDENTITY, witness=witness, steps=(step,), evidence=BY_EXPANDING
                )
        return _expanded(say("expand-arguments", n=", ".join(map(str, self.arities))))
