"""``check_ring``: test a user-defined ring against the axioms on samples."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import islice, product
from random import Random

from hfield.errors import NotInvertibleError, UndecidedError, shorten
from hfield.fields.base.ring import E, Ring

SAMPLES = 30
SAMPLED_MULTIPLES = (0, 1, -1, 2, 3)  # multiples of 1 among the samples
MAX_LISTED = 300  # elements of a finite ring that are listed
MULTIPLES = (1, 2, 3, 5, 7, 30, 2**31 - 1)  # multiples of 1; in characteristic 0 none of them is 0


@dataclass(frozen=True)
class Axiom:
    """An axiom of rings: ``holds(F, x, …)`` tests it on ``count`` elements."""

    text: str
    count: int
    holds: Callable[..., bool]


AXIOMS = (
    Axiom("x + y = y + x", 2, lambda F, x, y: F.agree(x + y, y + x)),
    Axiom("(x + y) + z = x + (y + z)", 3, lambda F, x, y, z: F.agree((x + y) + z, x + (y + z))),
    Axiom("x·y = y·x", 2, lambda F, x, y: F.agree(x * y, y * x)),
    Axiom("(x·y)·z = x·(y·z)", 3, lambda F, x, y, z: F.agree((x * y) * z, x * (y * z))),
    Axiom("x·(y + z) = x·y + x·z", 3, lambda F, x, y, z: F.agree(x * (y + z), x * y + x * z)),
    Axiom("x + 0 = x", 1, lambda F, x: F.agree(x + F.zero, x)),
    Axiom("x·1 = x", 1, lambda F, x: F.agree(x * F.one, x)),
    Axiom("x·0 = 0", 1, lambda F, x: F.is_zero(x * F.zero)),
    Axiom("x − x = 0", 1, lambda F, x: F.is_zero(x - x)),
    Axiom("x + (−x) = 0", 1, lambda F, x: F.is_zero(x + -x)),
    Axiom("x − y = x + (−y)", 2, lambda F, x, y: F.agree(x - y, x + -y)),
    Axiom("1 ≠ 0", 0, lambda F: not F.is_zero(F.one)),
)


def _is_multiple(F: Ring) -> bool:
    five = F.one + F.one + F.one + F.one + F.one
    return F.equal(F(5), five) and F.equal(F(-5), -five)


def _is_of_characteristic(F: Ring) -> bool:
    p = F.characteristic
    nonzero = range(1, min(p, 50)) if p else MULTIPLES
    return (not p or F.is_zero(F(p))) and not any(F.is_zero(F(n)) for n in nonzero)


def _has_inverse(F: Ring[E], x: E) -> bool:
    try:
        return F.agree(x * F.inverse(x), F.one)
    except NotInvertibleError:
        return F.is_zero(x) or not F.is_field


def _is_consistent_unit(F: Ring[E], x: E) -> bool:
    try:
        F.inverse(x)
    except NotInvertibleError:
        return not F.is_unit(x)
    return F.is_unit(x)


def _has_annihilator(F: Ring[E], x: E) -> bool:
    y = F.annihilator(x)
    return y is None or (not F.is_zero(y) and F.is_zero(x * y))


def _is_listed(F: Ring) -> bool:
    if F.order is None or F.order > MAX_LISTED:
        return True
    found = list(islice(F.elements(), F.order + 1))
    begins = F.is_zero(found[0]) and F.equal(found[1], F.one)
    return begins and len(found) == len({F.key(x) for x in found}) == F.order


# Properties that a ring declares, as far as samples can refute them.
PROMISES = (
    Axiom("F(x) = x", 1, lambda F, x: F.equal(F(x), x)),
    Axiom("F(5) = 1 + 1 + 1 + 1 + 1 and F(−5) = −F(5)", 0, _is_multiple),
    Axiom("F.characteristic is the additive order of 1", 0, _is_of_characteristic),
    Axiom("F(F.text(x)) = x", 1, lambda F, x: F.equal(F(F.text(x)), x)),
    Axiom("F.key(x) = F.key(y) exactly if x = y", 2,
          lambda F, x, y: (F.key(x) == F.key(y)) == F.equal(x, y)),
    Axiom("x·F.inverse(x) = 1; in a field only 0 has none", 1, _has_inverse),
    Axiom("F.is_unit(x) exactly if there is F.inverse(x)", 1, _is_consistent_unit),
    Axiom("x·F.annihilator(x) = 0", 1, _has_annihilator),
    Axiom("F.elements() lists F.order elements, 0 and 1 first", 0, _is_listed),
)  # fmt: skip


@dataclass(frozen=True)
class RingReport:
    """The result of testing a ring on samples: the axioms that ``failed``, with the elements, and the
    ``unknown`` ones with reasons.

    Its truth value is True if nothing failed. This proves nothing beyond the ``samples`` elements that were
    tested.
    """

    ring: str
    samples: int
    failed: tuple[str, ...]
    unknown: tuple[str, ...]

    def __bool__(self) -> bool:
        return not self.failed

    def __str__(self) -> str:
        count = {0: "no axiom fails", 1: "one axiom fails"}
        result = count.get(len(self.failed), f"{len(self.failed)} axioms fail")
        lines = [f"{self.ring}: {result} on {self.samples} samples"]
        lines += [f"  fails: {text}" for text in self.failed]
        lines += [f"  not known: {text}" for text in self.unknown]
        return "\n".join(lines)

    __repr__ = __str__


def check_ring(ring: Ring, samples: int = SAMPLES, seed: int = 1) -> RingReport:
    """Test a user-defined ring against the axioms of a commutative ring with 1, on some of its elements.

    The test also checks what the ring states about itself: characteristic, texts, keys, inverses,
    annihilators, and the elements of a finite ring. An axiom that raises anything but :class:`UndecidedError`
    fails. The same seed gives the same samples: small multiples of 1, the ring's generators, and values of
    ``ring.random``.

    >>> from hfield import QQ
    >>> check_ring(QQ)
    QQ: no axiom fails on 30 samples
    """
    rng = Random(seed)
    failed, unknown = list[str](), list[str]()
    try:
        elements = [*map(ring, SAMPLED_MULTIPLES), *ring.names().values()]
        elements += [ring.random(rng) for _ in range(samples - len(elements))]
    except Exception as error:
        return RingReport(ring.name, 0, (f"there are elements: {_error_text(error)}",), ())
    for axiom in (*AXIOMS, *PROMISES):
        try:
            place = _counterexample(ring, axiom, elements, rng)
        except UndecidedError as error:
            unknown.append(f"{axiom.text}: {error}")
            continue
        if place is not None:
            failed.append(axiom.text + place)
    return RingReport(ring.name, len(elements), tuple(failed), tuple(unknown))


def _counterexample(ring: Ring[E], axiom: Axiom, elements: Sequence[E], rng: Random) -> str | None:
    """Return elements for which an axiom fails, or None. Raises UndecidedError if that is not known."""
    small = elements[: len(SAMPLED_MULTIPLES)]
    places = [
        *product(small, repeat=min(axiom.count, 2)),
        *((x, rng.choice(elements)) for x in elements),
    ]
    undecided: UndecidedError | None = None
    for start in places if axiom.count else [()]:
        values = (*start, rng.choice(elements), rng.choice(elements))[: axiom.count]
        where = "".join(
            f"{', ' if n else ', for '}{name} = {_text(ring, x)}"
            for n, (name, x) in enumerate(zip("xyz", values, strict=False))
        )
        try:
            if not axiom.holds(ring, *values):
                return where
        except UndecidedError as error:
            undecided = undecided or error
        except Exception as error:  # whatever a class of somebody's raises
            return f"{where}: {_error_text(error)}"
    if undecided is not None:
        raise undecided
    return None


def _error_text(error: Exception) -> str:
    return f"{type(error).__name__}: {shorten(error)}"


def _text(ring: Ring[E], x: E) -> str:
    try:
        return shorten(ring.text(x))
    except Exception:  # it is an error of the ring that is looked for
        return shorten(repr(x))
