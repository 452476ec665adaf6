"""Algebras over GF(q)(t) that ramify at given places, checked by the symbols at all places."""

import pytest

from hfield import QuaternionAlgebra
from hfield.errors import RingError


@pytest.mark.parametrize(
    ("field", "places"),
    [
        ("GF(2)(t)", []),
        ("GF(2)(t)", ["t^2+t+1", "inf"]),
        ("GF(2)(t)", ["t", "t+1", "t^2+t+1", "inf"]),
        ("GF(3)(t)", ["t^2+1", "inf"]),
        ("GF(3)(t)", ["t^2+1", "t^3+2*t+1"]),
        ("GF(3)(t)", ["t", "t+1", "t+2", "t^2+1", "t^2+t+2", "inf"]),
        ("GF(4)(t)", ["t", "t+1"]),
        ("GF(5)(t)", ["t^2+2", "t^2+3"]),
        ("GF(8)(t)", ["t^2+t+1", "inf"]),
        ("GF(9)(t)", ["t", "inf"]),
        ("GF(101)(t)", ["t^2+2", "inf"]),
    ],
)
def test_an_algebra_ramifies_at_the_given_places(field: str, places: list[str]) -> None:
    found = QuaternionAlgebra.from_ramification(field, places)
    assert sorted(map(str, found.ramified_places())) == sorted(places)


@pytest.mark.parametrize(
    ("field", "places", "reason"),
    [
        ("GF(3)(t)", ["t"], "even number of places, and 1"),
        ("GF(3)(t)", ["t", "t"], "named twice"),
        ("GF(3)(t)", ["t^2", "inf"], "not a place"),
        ("QQ(t)", ["t", "inf"], "number fields and GF"),
    ],
)
def test_other_places_are_refused(field: str, places: list[str], reason: str) -> None:
    with pytest.raises(RingError, match=reason):
        QuaternionAlgebra.from_ramification(field, places)
