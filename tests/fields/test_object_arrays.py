"""Object arrays over rings without a loop, against the operations of single elements."""

from random import Random

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from hfield import H, Quaternion, QuaternionAlgebra, ring
from hfield.errors import NotInvertibleError
from hfield.fields.base.array_storage.object_arrays import ObjectArrays
from tests.thorough import cases

RINGS = (
    *("QQ(sqrt(2))", "QQ[s]/(s^3-2)", "QQ[s]/(s^4-2)", "GF(5)(t)", "GF(2)(t)", "QQ(x)", "QQ[x,y]", "RR"),
    *("GF(18446744073709551629)", "GF(2^100)", "GF(3^11)", "ZZ/99999999999999999999", "Qp(5)"),
)  # fmt: skip


def drawn(A: QuaternionAlgebra, rng: Random, count: int) -> tuple[list[Quaternion], Quaternion]:
    """Elements, a zero among them, and the array of them."""
    singles = [A(*(A.ring.random(rng) for _ in range(4))) for _ in range(count)] + [A(0)]
    return singles, A(*([q.coordinates[n] for q in singles] for n in range(4)))


@settings(max_examples=cases(75), deadline=None)
@given(st.sampled_from(RINGS), st.integers(0, 10**6))
def test_arrays_are_what_elements_are(name: str, seed: int) -> None:
    rng, R = Random(seed), ring(name)
    A = QuaternionAlgebra(R, R.random(rng), R(2), R(rng.choice([0, 1])))
    (first, p), (second, q) = drawn(A, rng, 3), drawn(A, rng, 3)
    pairs = list(zip(first, second, strict=True))
    for many, one in (
        (p * q, [x * y for x, y in pairs]),
        (p + q, [x + y for x, y in pairs]),
        (p - q, [x - y for x, y in pairs]),
        (-p, [-x for x in first]),
        (p.conjugate(), [x.conjugate() for x in first]),
        (p * 3, [x * 3 for x in first]),
        (p[1] * q, [first[1] * y for y in second]),
    ):
        assert list(many) == one
        assert [A(*c) for c in zip(*many.coordinates, strict=True)] == one
    assert [R.scalar(x) for x in p.norm()] == [x.norm() for x in first]
    assert [R.scalar(x) for x in p.trace()] == [x.trace() for x in first]
    assert (p == q).tolist() == [x == y for x, y in pairs]
    assert p.is_zero().tolist() == [x.is_zero() for x in first]
    units = [R.is_unit(x.norm()) for x in first]
    assert p.units().tolist() == units
    good = p[[n for n, unit in enumerate(units) if unit]]
    assert list(good.inverse()) == [
        x.inverse() for x, unit in zip(first, units, strict=True) if unit
    ]
    with pytest.raises(NotInvertibleError, match="at index"):
        p.inverse()
    table = p.reshape(2, 2) * q.reshape(2, 2)[0]
    assert table.shape == (2, 2)
    assert table[1, 0] == first[2] * second[0]
    assert p.product() == first[0] * first[1] * first[2] * first[3]


@pytest.mark.parametrize("name", ["QQ(sqrt(2))", "GF(5)(t)", "GF(18446744073709551629)"])
def test_products_make_no_elements_of_the_ring(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    A = H(name)
    singles, p = drawn(A, Random(1), 6)
    how = A.array_storage
    assert isinstance(how, ObjectArrays)
    wanted = [x * x + x for x in singles]
    p * p + p  # the functions are made at the first call
    made, multiplied = [], []
    multiply = how.entries.product

    def product(x: object, y: object) -> object:
        multiplied.append(x)
        return multiply(x, y)

    monkeypatch.setattr(how.entries, "product", product)
    for operation in ("encode", "coordinates"):
        monkeypatch.setattr(type(how.entries), operation, lambda *_: made.append(_))
    found = p * p + p
    assert len(multiplied) == len(singles)
    assert not made
    monkeypatch.undo()
    assert list(found) == wanted


def test_arrays_of_a_library_stay_its_own() -> None:
    block = H("RDF")(np.arange(3), 0.5, 0, 1)
    assert (block * block).coordinates[0].dtype == np.float64
