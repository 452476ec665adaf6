"""The default storage of elements and arrays of any ring, against the table of products."""

import pickle
from contextlib import suppress
from itertools import product
from random import Random

import numpy as np
import pytest

from hfield import H, Quaternion, QuaternionAlgebra, ring
from hfield.compiling import memory
from hfield.core.product import Constants
from hfield.errors import CoercionError, HFieldError
from hfield.fields.base.arrays import check_shapes, objects, one_shape
from hfield.fields.base.storage.base import BatchStorage, Storage
from tests.subcases import first_quick, subcases

NAMES = ("QQ", "QQ[x]", "GF(5)[x,y]", "ZZ/6", "QQ(sqrt(2))", "QQ(x)[u]/(u^2-x)")


def table(R, constants, p, q):
    """Return p·q from i² = a + t·i, j² = b, ij = k, ji = t·j − k, summing over pairs of basis elements."""
    a, b, t = constants.a, constants.b, constants.t
    o, e = R.zero, R.one
    products = {
        (1, 1): (a, t, o, o), (1, 2): (o, o, o, e), (1, 3): (o, o, a, t),
        (2, 1): (o, o, t, -e), (2, 2): (b, o, o, o), (2, 3): (t * b, -b, o, o),
        (3, 1): (o, o, -a, o), (3, 2): (o, b, o, o), (3, 3): (-(a * b), o, o, o),
    }  # fmt: skip
    units = [tuple(e if m == n else o for n in range(4)) for m in range(4)]
    products |= {(0, n): units[n] for n in range(4)} | {(n, 0): units[n] for n in range(4)}
    total = [o, o, o, o]
    for (m, n), four in products.items():
        for k in range(4):
            total[k] = total[k] + p[m] * q[n] * four[k]
    return tuple(total)


def same(R, p, q):
    return all(map(R.equal, p, q))


def drawn(name, count=4):
    R, rng = ring(name), Random(5)
    constants = Constants(R.random(rng) + 1, R(2), R.random(rng))
    elements = [tuple(R.random(rng) for _ in range(4)) for _ in range(count)]
    return R, constants, [*elements, (R.one, R.zero, R.zero, R.zero), (R.zero,) * 4]


@pytest.mark.parametrize("name", NAMES)
def test_storage_of_elements_over_any_ring(name: str) -> None:
    R, constants, elements = drawn(name)
    stored = Storage(R, constants)
    zero = (R.zero,) * 4
    for p, q in product(elements, elements):
        assert same(R, stored.product(p, q), table(R, constants, p, q))
        assert same(R, stored.sum(p, q), [x + y for x, y in zip(p, q, strict=True)])
        assert same(R, stored.difference(p, q), [x - y for x, y in zip(p, q, strict=True)])
        assert stored.equal(p, q) == same(R, p, q)
        assert (stored.key(p) == stored.key(q)) == same(R, p, q)
    for p in elements:
        conjugate = stored.conjugate(p)
        assert same(R, stored.negative(p), [-x for x in p])
        assert same(R, stored.product(p, conjugate), (stored.norm(p), R.zero, R.zero, R.zero))
        assert same(R, stored.sum(p, conjugate), (stored.trace(p), R.zero, R.zero, R.zero))
        assert same(R, stored.scaled(p, R(3)), [x * 3 for x in p])
        assert stored.is_zero(p) == same(R, p, zero)
        assert same(R, stored.read(stored.state(p)), p)
        inverse = stored.inverse(p)
        assert (inverse is None) == (not R.is_unit(stored.norm(p)))
        if inverse is not None:
            assert same(R, stored.product(p, inverse), (R.one, R.zero, R.zero, R.zero))
    assert stored.coordinates(stored.encode(elements[0])) == elements[0]
    assert (
        stored.explain("product")
        == "# the formula of hfield.core.product, on the coordinates: product"
    )
    assert (stored.ring, stored.constants, stored.is_batch, stored.is_unique) == (
        R,
        constants,
        False,
        False,
    )


@pytest.mark.parametrize("name", NAMES)
def test_storage_of_arrays_over_any_ring(name: str) -> None:
    R, constants, elements = drawn(name)
    stored, one = BatchStorage(R, constants), Storage(R, constants)
    columns = [[p[n] for p in elements] for n in range(4)]
    p = stored.read(tuple(columns))
    q = stored.read(tuple(list(reversed(c)) for c in columns))
    backwards = list(reversed(elements))

    def entries(array):
        return [stored.single(stored.part(array, n)) for n in range(len(elements))]

    assert stored.shape(p) == (len(elements),)
    for operation in ("product", "sum", "difference"):
        found = entries(getattr(stored, operation)(p, q))
        wanted = [getattr(one, operation)(x, y) for x, y in zip(elements, backwards, strict=True)]
        assert all(same(R, x, y) for x, y in zip(found, wanted, strict=True))
    for operation in ("negative", "conjugate"):
        found = entries(getattr(stored, operation)(p))
        assert all(
            same(R, x, getattr(one, operation)(y)) for x, y in zip(found, elements, strict=True)
        )
    for operation in ("norm", "trace"):
        found = [R.scalar(x) for x in getattr(stored, operation)(p)]
        assert all(
            R.equal(x, getattr(one, operation)(y)) for x, y in zip(found, elements, strict=True)
        )
    assert list(stored.units(p)) == [R.is_unit(one.norm(x)) for x in elements]
    assert list(stored.equal(p, q)) == [
        one.equal(x, y) for x, y in zip(elements, backwards, strict=True)
    ]
    assert list(stored.is_zero(p)) == [one.is_zero(x) for x in elements]
    assert stored.equal(p, p).dtype == bool
    assert stored.inverse(p) is None  # 0 is among them
    good = [n for n, x in enumerate(elements) if R.is_unit(one.norm(x))]
    units = stored.part(p, good)
    assert stored.shape(units) == (len(good),)
    ones = stored.product(units, stored.inverse(units))
    assert stored.equal(ones, stored.lift((R.one, R.zero, R.zero, R.zero))).all()
    square = stored.reshaped(p, (2, 3))
    assert stored.shape(square) == (2, 3)
    assert same(R, stored.single(stored.part(square, (1, 0))), elements[3])
    single = stored.lift(elements[0])
    assert stored.shape(single) == ()
    assert same(R, stored.single(single), elements[0])
    assert stored.shape(stored.product(single, p)) == (len(elements),)
    assert stored.shape(stored.sum(square, single)) == (2, 3)
    for operation, word in (("product", "multiply"), ("sum", "add"), ("difference", "subtract"),
                            ("equal", "compare")):  # fmt: skip
        with pytest.raises(CoercionError) as caught:
            getattr(stored, operation)(p, stored.part(p, slice(0, 4)))
        assert str(caught.value) == (
            f"cannot {word} arrays of quaternions of the shapes (6,) and (4,): expected one shape for both, "
            "or shapes that broadcast as numpy's do"
        )
    for work in (stored.to_array, stored.from_array):
        with pytest.raises(CoercionError) as caught:
            work(p)
        assert str(caught.value) == (
            f"arrays of quaternions over {R} have no form of integers: pickle them"
        )
    with pytest.raises(
        CoercionError, match=r"shapes \(6,\), \(4,\), \(6,\), \(6,\); expected one shape"
    ):
        stored.read((columns[0], columns[1][:4], columns[2], columns[3]))
    assert stored.shape(stored.read((columns[0], R.one, R.zero, columns[3]))) == (6,)


def test_shapes() -> None:
    a, b = np.zeros((3, 1)), np.zeros((2,))
    assert [x.shape for x in one_shape([a, b, a, a])] == [(3, 2)] * 4
    assert one_shape([a, a])[0] is a
    assert one_shape([a + 7, b, a, a])[0].tolist() == [[7.0, 7.0]] * 3
    polynomials = ring("QQ[x]")
    entry = polynomials.scalar(polynomials.array(polynomials.gen))
    assert type(entry) is type(polynomials.gen)
    assert entry == polynomials.gen
    assert ring("RDF").array(np.array([1, 2])).dtype == np.float64
    check_shapes((3, 1), (2,), "add")
    with pytest.raises(
        CoercionError, match=r"cannot add arrays of quaternions of the shapes \(3,\) and \(2,\)"
    ):
        check_shapes((3,), (2,), "add")
    R = ring("QQ")
    assert objects([], R).shape == (0,)
    assert objects([[1, 2], [3, 4]], R).shape == (2, 2)
    assert objects(np.array([[1, 2]]), R)[0, 1] == 2
    assert objects(5, R).shape == ()
    with pytest.raises(
        CoercionError, match=r"have the shapes \(1,\), \(2,\); expected the same shape"
    ):
        objects([[1], [2, 3]], R)
    x = objects([1, "1/2"], R)
    for found, wanted in (
        (x + 1, [2, R("3/2")]),
        (2 * x, [2, 1]),
        (x * x, [1, R("1/4")]),
        (-x, [-1, R("-1/2")]),
    ):
        assert list(found) == wanted
    y = np.add(x, x, out=objects([0, 0], R))
    assert list(y) == [2, 1]
    assert isinstance((x[0:1] + x[0:1]).reshape(()) * x, type(x))
    assert list(x == x) == [True, True]


@subcases("name", ["ZZ", "QQ", "ZZ/6", "QQ(x)", "GF(4)(t)", "GF(9)", "GF(2^100)",
                                  "QQ(sqrt(2))",
                                  "QQ[s]/(s^3-2)", "QQ[s]/(s^5-s-1)", "RR"])  # fmt: skip
def test_compact_forms_compute_the_table(name: str) -> None:
    R, constants, elements = drawn(name)
    stored = R.storage(constants)
    forms = [stored.encode(p) for p in elements]
    for (p, x), (q, y) in product(list(zip(elements, forms, strict=True)), repeat=2):
        assert same(R, stored.coordinates(stored.product(x, y)), table(R, constants, p, q))
        assert same(
            R, stored.coordinates(stored.sum(x, y)), [v + w for v, w in zip(p, q, strict=True)]
        )
    for p, x in zip(elements, forms, strict=True):
        assert same(R, stored.coordinates(x), p)
        conjugate = stored.coordinates(stored.conjugate(x))
        assert same(R, table(R, constants, p, conjugate), (stored.norm(x), R.zero, R.zero, R.zero))
        assert R.equal(stored.trace(x), p[0] + conjugate[0])
    if name == "GF(9)":  # arrays over it are galois's, and tested with galois
        return
    arrays = R.array_storage(constants)
    columns = tuple([p[n] for p in elements] for n in range(4))
    array = arrays.read(columns)
    squares = arrays.product(array, array)
    for n, p in enumerate(elements):
        assert same(R, arrays.single(arrays.part(squares, n)), table(R, constants, p, p))


def test_arrays_of_an_algebra_without_a_form_of_integers() -> None:
    H = QuaternionAlgebra(ring("QQ[x]"), -1, -1)
    with pytest.raises(HFieldError):
        H([[1, 2, 3, 4], [1, 2, 3]])


VALUES = (
    *("GF(2)", "GF(7)", "GF(9)", "GF(2^8)", "GF(3^5)", "GF(3^11)", "GF(2^40)", "GF(4294967291)"),
    *("GF(10000000000000061)", "ZZ", "QQ", "ZZ/6", "RDF", "RR", "QQ(sqrt(2))", "QQ[x]"),
)


def spoilt(*arrays):
    """Write to arrays, whatever their flags say, and tell whether that could be done."""
    done = []
    for array in arrays:
        with suppress(ValueError):
            array.flags.writeable = True
        with suppress(ValueError):
            array[...] = array.flat[-1]
            done.append(array)
    return bool(done)


@pytest.mark.parametrize("name", first_quick(reversed(VALUES), 10))
def test_nothing_that_a_caller_holds_changes_an_element(name: str) -> None:
    A = H(name)
    p = A([[0, 1, 2], [1, 0, 5]], 1, [3, 0, 1], 1)
    shown = str(p)
    read_only_coordinates = (p, p[0], p.reshape(6), +p, p**1, p + 0, *p)
    for q in (*read_only_coordinates, pickle.loads(pickle.dumps(p)), p.conjugate(), p * p):
        before = str(q)
        assert not spoilt(*q.coordinates, *q.vector_part.coordinates, q.scalar_part)
        assert (str(q), str(p)) == (before, shown)
    spoilt(p.norm(), p.trace(), p.units(), p.is_zero(), p == p)
    assert str(p) == shown

    taken = [np.array(c, subok=True) for c in p.coordinates]
    whole = [np.array([[0, 1, 1]], kind) for kind in (np.int64, np.uint8, np.int8, np.int64)]
    for values in (taken, whole):
        for q in (A(*values), A(tuple(values)), A.scalar(values[0])):
            before = str(q)
            assert str(Quaternion(A, q.coordinates)) == before
            own = [np.array(c, subok=True) for c in q.coordinates]
            other = Quaternion(A, (own[0], own[1], own[2], own[3]))
            kept = [v.copy() for v in values]
            assert spoilt(*own, *values)
            assert (str(q), str(other)) == (before, before)
            for v, k in zip(values, kept, strict=True):
                v[...] = k


@pytest.mark.parametrize("name", ["GF(7)", "GF(9)", "ZZ/6", "ZZ", "QQ"])
@pytest.mark.parametrize("size", [3, 4000])
def test_arrays_of_integers_are_copied(
    name: str, size: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(memory, "POOLED_BYTES", 1000)  # from which size buffers are reused
    A = H(name)
    p = A(np.arange(size) % 5, 1, 2, 0)
    for q in (p, p * p):
        assert not spoilt(q.to_array(), q[1:].to_array())
    assert (p == A(np.arange(size) % 5, 1, 2, 0)).all()
    stored = np.array(p.to_array())
    for kind in {stored.dtype, np.dtype(np.int64), np.dtype(np.int8)}:
        for frozen in (False, True):
            w = stored.astype(kind)
            w.flags.writeable = not frozen
            q = A.from_array(w)
            assert (q == p).all()
            assert spoilt(w)
            assert (q == p).all()
