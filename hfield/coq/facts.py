"""What is known at a place of a proof, and equations that follow from it by a linear combination."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from time import monotonic
from typing import Any

from hfield.coq.terms import Term, Terms
from hfield.errors import HFieldError, TooLargeError
from hfield.proving.polynomials.membership import Cofactors, Ideal
from hfield.proving.polynomials.vanishing import prime_factors

SHARE = 0.5  # of the time left, for one search
SLICE = 150  # pairs between two looks at the target
MAX_ELEMENTS = 400
MAX_COFACTORS = 500  # terms that Coq has to read for one equation


class NoProofError(HFieldError, ArithmeticError):
    """A formula for which no proof was found; the message says what was missing."""


@dataclass(frozen=True)
class Zero:
    """A known equation ``l = r``: a Coq term that proves it, and the polynomial ``l - r``."""

    proof: str
    polynomial: Any


@dataclass(frozen=True)
class Apart:
    """Two quaternions known to differ: the hypothesis that says so."""

    name: str
    left: Term
    right: Term


@dataclass(frozen=True)
class Facts:
    """All that is known at a place. ``units`` maps texts of scalars to proofs that they are not 0."""

    zeros: tuple[Zero, ...] = ()
    apart: tuple[Apart, ...] = ()
    units: tuple[tuple[str, str], ...] = ()

    def with_equation(self, name: str, left: Term, right: Term) -> "Facts":
        """Add ``left = right``, four equations if these are quaternions."""
        if left.is_scalar:
            new = [Zero(name, left.value - right.value)]
        else:
            pairs = zip(("re", "im", "jm", "km"), left.value, right.value, strict=True)
            new = [Zero(f"(f_equal {c} {name})", u - v) for c, u, v in pairs]
        return replace(self, zeros=(*self.zeros, *(z for z in new if z.polynomial != 0)))

    def with_unit(self, terms: Terms, proof: str, d: Term) -> "Facts":
        """Add that the scalar d is not 0, which makes ``inv d`` its inverse."""
        if d.text in dict(self.units):
            return self
        polynomial = d.value * terms.inverse_of(d) - 1
        unit = Zero(f"(inverse {d.inner} {proof})", polynomial)
        return replace(self, zeros=(*self.zeros, unit), units=(*self.units, (d.text, proof)))

    def with_difference(self, terms: Terms, name: str, left: Term, right: Term) -> "Facts":
        """Add ``left <> right``."""
        if not left.is_scalar:
            return replace(self, apart=(*self.apart, Apart(name, left, right)))
        if right.text == "0":
            return self.with_unit(terms, name, left)
        d = terms.binary("-", left, right)
        return self.with_unit(terms, f"(difference_apart laws _ _ {name})", d)


@dataclass(frozen=True)
class Combination:
    """``denominator·target`` as a combination of equations, each with the text of its cofactor."""

    parts: tuple[tuple[str, str], ...]
    denominator: int

    @property
    def text(self) -> str:
        """The proof as a Coq term."""
        out = "nil"
        for cofactor, proof in reversed(self.parts):
            out = f"(cons ({cofactor}) {proof} {out})"
        return out


def combine(terms: Terms, facts: Facts, target: Any, deadline: float) -> Combination | None:
    """Write a polynomial as a linear combination of what is known to be 0, or return None."""
    if target == 0:
        return Combination((), 1)
    prime = next((z for z in facts.zeros if _is_prime(z.polynomial)), None)
    if prime is None:
        found = _member(terms, 0, facts.zeros, target, deadline)
        if found is None:
            return None
        return Combination(_parts(terms, found, facts.zeros), found.denominator)
    p = int(prime.polynomial.leading_coefficient())
    others = tuple(z for z in facts.zeros if int(z.polynomial.content()) % p)
    rest, parts = target, tuple[tuple[str, str], ...]()
    if int(target.content()) % p:
        found = _member(terms, p, others, target, deadline)
        if found is None:
            return None
        parts = _parts(terms, found, others)
        for f, z in zip(found.factors, others, strict=True):
            rest -= f * z.polynomial
    # What is left is 0 modulo p, hence a multiple of p.
    multiple = terms.context.from_dict({m: int(c) // p for m, c in rest.to_dict().items()})
    return Combination((*parts, (polynomial_text(multiple, terms.atoms), prime.proof)), 1)


def _member(
    terms: Terms, p: int, zeros: Sequence[Zero], target: Any, deadline: float
) -> Cofactors | None:
    if not zeros:
        return None
    ideal = Ideal(terms.room, p)
    now = monotonic()
    limit = now + SHARE * max(deadline - now, 0)
    try:
        ideal.extend(z.polynomial for z in zeros)
        while True:
            complete = ideal.run(limit, SLICE)
            found = ideal.cofactors(target)
            if found is not None or complete or monotonic() > limit:
                return found
            if len(ideal.basis.leads) > MAX_ELEMENTS:
                return None
    except TooLargeError:
        return None


def _parts(terms: Terms, found: Cofactors, zeros: Sequence[Zero]) -> tuple[tuple[str, str], ...]:
    if sum(map(len, found.factors)) > MAX_COFACTORS:
        raise TooLargeError(f"the proof has cofactors of more than {MAX_COFACTORS} terms")
    pairs = zip(found.factors, zeros, strict=True)
    return tuple((polynomial_text(f, terms.atoms), z.proof) for f, z in pairs if f != 0)


def _is_prime(polynomial: Any) -> bool:
    """Tell whether this is a prime number (as an equation it gives the characteristic)."""
    if not polynomial.is_constant():
        return False
    n = int(polynomial.leading_coefficient())
    return n > 1 and prime_factors(n) == [n]


def polynomial_text(polynomial: Any, atoms: Sequence[str]) -> str:
    """Write a polynomial in Coq's notation."""
    out = ""
    for exponents, coefficient in polynomial.terms():
        c = int(coefficient)
        powers = [
            atom if n == 1 else f"pow ({atom}) {int(n)}"
            for atom, n in zip(atoms, exponents, strict=False)
            if n
        ]
        if not powers or abs(c) != 1:
            powers.insert(0, "1" if abs(c) == 1 else f"num {abs(c)}")
        body = " * ".join(powers)
        if out:
            out += f" {'-' if c < 0 else '+'} {body}"
        else:
            out = f"- ({body})" if c < 0 else body
    return out or "0"
