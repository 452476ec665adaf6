"""What prints a place, a prime, an ideal or an element of a field is read back as the same, in JSON too."""

import json
from collections.abc import Iterator
from itertools import islice
from random import Random
from typing import Any

import pytest

from hfield import QuaternionAlgebra, ring
from hfield.cli import main
from hfield.fields.quadratic_forms.ramification import place, places

NUMBER_FIELDS = ["QQ(sqrt(5))", "QQ(sqrt(-5))", "QQ(sqrt(17))", "QQ(I)", "QQ[s]/(s^2-5)", "QQ[s]/(2*s^3-3)",
                 "QQ[s]/(s^3-s^2-2*s-8)", "QQ[s]/(s^4-10*s^2+1)", 
                 "QQ(zeta5)", "QQ(sqrt(2),sqrt(3))"]  # fmt: skip
OTHERS = ["QQ", "GF(5)(t)", "GF(4)(t)", "GF(2)(t)", "Qp(5)", "Qp(2)", "GF(3)((t))"]
LOCAL = {"Qp(5)", "Qp(2)", "GF(3)((t))"}


def elements(K: Any, has_generator: bool) -> Iterator[Any]:
    """Yield some elements: small combinations and quotients of generators."""
    rng = Random(1)
    gen = K.gen if has_generator else K(K.characteristic or 7)
    for _ in range(12):
        x = K(rng.randrange(-9, 10)) + gen * K(rng.randrange(-9, 10))
        yield x
        yield x / (gen + K(3)) if gen + K(3) else x


@pytest.mark.parametrize("name", NUMBER_FIELDS)
def test_primes_and_ideals(name: str) -> None:
    """The text of a prime is that prime, as a place and as an ideal; so are products, by their texts."""
    K: Any = ring(name)
    for p in (2, 3, 5, 7, 11, 13, 17):
        above = K.primes_above(p)
        assert len({str(P) for P in above}) == len(above)
        for P in above:
            a = K.ideal(P)
            assert K.ideal(str(P)) == K.ideal(str(a)) == K.ideal(list(P.generators)) == a
            assert place(K, str(P)) == P
            b = a**2 * K.ideal(above[0]) ** -1
            assert K.ideal(str(b)) == b


@pytest.mark.parametrize("name", NUMBER_FIELDS + OTHERS)
def test_places_and_elements(name: str) -> None:
    """The text of a place is that place, that of an element is that element."""
    K: Any = ring(name)
    for v in islice(places(K), 12) if name not in LOCAL else K.places():
        assert place(K, str(v)) == v
    for x in elements(K, name not in ("QQ", "Qp(5)", "Qp(2)")):
        assert K.text(K(K.text(x))) == K.text(x)
        assert name in LOCAL or K(K.text(x)) == x


@pytest.mark.parametrize("name", ["QQ(sqrt(5))", "QQ[s]/(s^2-5)"])
def test_brandt_matrices_of_texts(name: str) -> None:
    """A prime and its text have one Brandt matrix, whether it is split, inert or ramified."""
    K: Any = ring(name)
    classes = QuaternionAlgebra(K, -1, -1).maximal_order().class_set()
    for p in (2, 5, 11):
        for P in K.primes_above(p):
            assert classes.brandt_matrix(str(P)) == classes.brandt_matrix(P)


def test_json_of_orders(capsys: pytest.CaptureFixture[str]) -> None:
    """The factors of an ideal in JSON have the ideal as their product."""
    K: Any = ring("QQ(sqrt(5))")
    assert (
        main(["order", "(-1,-1|QQ(sqrt(5)))", "--level", "ideal(5,sqrt(5))", "--format", "json"])
        == 0
    )
    found = list(_ideals(json.loads(capsys.readouterr().out)))
    assert found
    for entry in found:
        product = K.ideal(1)
        for text, e in entry["factorisation"]:
            product = product * K.ideal(text) ** e
        assert product == K.ideal(entry["generators"])


def _ideals(data: Any) -> Iterator[dict[str, Any]]:
    """Yield the ideals in JSON data."""
    if isinstance(data, dict) and "factorisation" in data:
        yield data
    for part in data.values() if isinstance(data, dict) else data if isinstance(data, list) else ():
        yield from _ideals(part)
