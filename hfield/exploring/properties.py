"""The properties that define collections of elements, as tests and as statements."""

from collections.abc import Callable
from typing import Any, NamedTuple

from hfield.algebra.quaternion import Quaternion


class Condition(NamedTuple):
    """The condition of a collection: a name, and a value if norm or trace is given."""

    name: str
    value: Any = None  # None where the name says all


_TESTS: dict[str, Callable[[Quaternion, Any], bool]] = {
    "units": lambda q, _: q.is_unit(),
    "zero divisors": lambda q, _: q.is_zero_divisor(),
    "idempotents": lambda q, _: q.is_idempotent(),
    "nilpotents": lambda q, _: q.is_nilpotent(),
    "norm": lambda q, n: q.ring.equal(q.norm(), n),
    "trace": lambda q, s: q.ring.equal(q.trace(), s),
}
CONDITIONS = {
    "units": "norm(q) != 0",
    "zero divisors": "norm(q) == 0",
    "idempotents": "q*q == q",
    "nilpotents": "q*q == 0",
    "norm": "norm(q) == {}",
    "trace": "trace(q) == {}",
}


def has_property(q: Quaternion, condition: Condition) -> bool:
    """Return whether a single element has the property of a collection."""
    return _TESTS[condition.name](q, condition.value)
