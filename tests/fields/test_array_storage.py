"""Arrays stored as rows of integers: equal to the one formula on the ring's own arrays, bit by bit."""

import copy
import pickle
import subprocess
import sys
from itertools import product as cartesian
from random import Random

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from hfield import H, QuaternionAlgebra, ring
from hfield.algebra.quaternion import product_plus
from hfield.compiling import calling, machine_code
from hfield.compiling.arithmetics import register_tables
from hfield.compiling.arithmetics.extension_fields import PolynomialArithmetic
from hfield.compiling.arithmetics.logarithms import LogarithmicField
from hfield.compiling.arithmetics.register_tables import RegisterField
from hfield.compiling.threads import threads
from hfield.core.product import conjugate, multiply, norm, trace
from hfield.errors import CoercionError, NotInvertibleError
from hfield.fields.base.array_storage.labels import LabelArrays
from hfield.fields.base.array_storage.rows import RowArrays
from tests.galois_classes import galois_class
from tests.subcases import first_quick, share_quick, slow, subcases
from tests.thorough import THOROUGH, pairwise, part

# every arithmetic and word, at both ends of what it serves
FINITE = [
    "GF(2)", "GF(7)", "GF(251)", "GF(257)", "GF(65521)", "GF(8388617)", "GF(2147483647)",
    "GF(4294967291)", "ZZ/6", "ZZ/256", "ZZ/8388608", "ZZ/4294967296",
    "GF(4)", "GF(2^8, x^8+x^4+x^3+x+1)", "GF(2^9)", "GF(2^32)", "GF(2^33)", "GF(2^64)",
    "GF(9, x^2+1)", "GF(7^3)", "GF(65521^2)", "GF(3^4)", "GF(3^5)", "GF(3^10)", "GF(37^4)",
]  # fmt: skip
COUNT = 20


def constants(F, seed):
    """Structure constants: Hamilton's, and some of every kind."""
    rng = Random(seed)
    return [(-1, -1, 0), tuple(F.random(rng) for _ in range(3))]


def elements(F, rng, count):
    """Random elements, and the least and greatest labels, and those next to the middle."""
    q = F.order
    ends = [F.zero, F.one, -F.one] + ([F.from_label(n) for n in (q // 2, q // 2 - 1)] if q else [])
    return [
        tuple(rng.choice(ends) if rng.random() < 0.4 else F.random(rng) for _ in range(4))
        for _ in range(count)
    ]


@pytest.mark.parametrize(
    "name", first_quick(["ZZ/4294967296", "GF(9, x^2+1)", "GF(7)", "GF(2^9)"], 2)
)
def test_a_product_and_a_sum_in_one_loop(name):
    F = ring(name)
    for a, b, t in [(-1, -1, 0), (0, 0, 1)]:
        A = QuaternionAlgebra(F, a, b, t)
        coordinates = (zip(*elements(F, Random(n), COUNT), strict=True) for n in range(3))
        p, q, r = (A(*map(list, rows)) for rows in coordinates)
        assert hasattr(p._how, "product_plus")
        assert (product_plus(p, q, r) == p * q + r).all()
        assert (product_plus(p, A.basis[2], r) == p * A.basis[2] + r).all()


def extremes(F):
    """Elements whose coordinates are farthest from 0 modulo n, with all signs."""
    half = [F.from_label(F.order // 2), F.from_label((F.order + 1) // 2 % F.order)]
    return list(cartesian(half, repeat=4))


def scalars(A, p, name):
    """The norms or traces of an array; over finite rings as labels, for galois takes seconds a field."""
    how = A.array_storage
    if not isinstance(how, LabelArrays):
        return [A.ring.scalar(x) for x in getattr(p, name)()]
    return [A.ring.from_label(int(n)) for n in how.kernel(name)(p._stored)[0][0]]


def agrees(A, P, Q):
    """Compare every operation on arrays with the formula on the coordinates of each element."""
    F, c = A.ring, A.constants
    p, q = (A(*map(list, zip(*four, strict=True))) for four in (P, Q))
    assert isinstance(A.array_storage, RowArrays)

    def same(array, expected):
        found = [array[n].coordinates for n in range(len(expected))]
        assert all(
            F.equal(x, y)
            for f, e in zip(found, expected, strict=True)
            for x, y in zip(f, e, strict=True)
        )

    pairs = list(zip(P, Q, strict=True))
    same(p * q, [multiply(c, x, y) for x, y in pairs])
    same(p + q, [tuple(u + v for u, v in zip(x, y, strict=True)) for x, y in pairs])
    same(p - q, [tuple(u - v for u, v in zip(x, y, strict=True)) for x, y in pairs])
    same(-p, [tuple(-u for u in x) for x in P])
    same(p.conjugate(), [conjugate(c, x) for x in P])
    same(p * A(*Q[0]), [multiply(c, x, Q[0]) for x in P])
    same(A(*Q[0]) * p, [multiply(c, Q[0], x) for x in P])
    same(p**3, [multiply(c, multiply(c, x, x), x) for x in P])
    for name, formula in (("norm", norm), ("trace", trace)):
        found = scalars(A, p, name)
        assert [F.key(x) for x in found] == [F.key(formula(c, x)) for x in P]
    expected = [all(F.equal(u, v) for u, v in zip(x, y, strict=True)) for x, y in pairs]
    assert (p == q).tolist() == expected
    assert (p == p).all()
    assert p.is_zero().tolist() == [all(map(F.is_zero, x)) for x in P]
    units = [n for n, x in enumerate(P) if F.is_unit(norm(c, x))]
    if units:
        assert (p[units].inverse() * p[units] == 1).all()
        assert (p[units] ** -2 * p[units] * p[units] == 1).all()
    if len(units) < len(P):
        first = next(n for n in range(len(P)) if n not in units)
        with pytest.raises(NotInvertibleError, match=rf"at index \({first},\)"):
            p.inverse()


@pytest.mark.slow
@pytest.mark.parametrize("name", part(FINITE, 2))
def test_finite_rings(name):
    F, rng = ring(name), Random(name)
    for a, b, t in constants(F, name):
        P, Q = (extremes(F) + elements(F, rng, COUNT) for _ in range(2))
        agrees(QuaternionAlgebra(F, a, b, t), P, Q)


BYTES = [
    "GF(4)",
    "GF(2^8)",
    "GF(9)",
    "GF(3^3)",
    "GF(3^4)",
    "GF(3^5)",
    "GF(5^2)",
    "GF(5^3)",
    "GF(13^2)",
]


@pytest.mark.slow
@pytest.mark.parametrize(("name", "instruction"), pairwise(BYTES, (True, False)))
def test_fields_whose_labels_are_bytes(name, instruction, monkeypatch):
    if not instruction:
        monkeypatch.setattr(machine_code, "processor_has", lambda feature: False)
    elif not (machine_code.available() and machine_code.processor_has(register_tables.PROCESSOR)):
        pytest.skip("this processor has no instruction that looks bytes up in a table of 128")
    F, rng = ring(name), Random(name)
    kinds = (*constants(F, name), (1, 1, 1), (F.random(rng), 0, -1), (0, 0, 0))
    turn = BYTES.index(name) + instruction
    for c in kinds if THOROUGH else (kinds[turn % 5], kinds[(turn + 2) % 5]):
        A = QuaternionAlgebra(F, *c)
        assert isinstance(A.array_storage.arithmetic, RegisterField) == instruction
        P, Q = (elements(F, rng, 70) for _ in range(2))  # a turn of 64, and one that is not full
        agrees(A, P, Q)


def multiplied(F, u, v):
    """Labels of products, by the polynomials whose coefficients are a label's digits."""
    p, f, n = F.characteristic, F.coefficients, len(F.coefficients) - 1
    digits = [[x // p**k % p for k in range(n)] for x in (u.astype(int), v.astype(int))]
    out = [
        sum(digits[0][i] * digits[1][m - i] for i in range(n) if 0 <= m - i < n)
        for m in range(2 * n - 1)
    ]
    for m in reversed(range(n, 2 * n - 1)):  # x^n is what the monic f leaves of it
        for k in range(n):
            out[m - n + k] = out[m - n + k] - out[m] * f[k]
    return sum(out[k] % p * p**k for k in range(n))


@pytest.mark.parametrize("name", BYTES)
def test_all_products_of_bytes(name):
    F = ring(name)
    every = np.arange(F.order, dtype="u1")
    how = QuaternionAlgebra(F, -1, -1).array_storage
    u, v = (x.ravel() for x in np.meshgrid(every, every))
    assert (how.kernel("scalar product")((u,), (v,))[0][0] == multiplied(F, u, v)).all()


@pytest.mark.parametrize("name", ["GF(2)", "GF(3)", "GF(4)", slow("ZZ/4")])
def test_every_product_of_a_small_ring(name):
    F = ring(name)
    every = list(F.elements())
    four = list(cartesian(every, repeat=4))
    for a, b, t in ((-1, -1, 0), (1, every[-1], 1), (every[-1], 0, every[-1])):
        A = QuaternionAlgebra(F, a, b, t)
        p = A(*map(list, zip(*four, strict=True)))
        table = p.reshape(-1, 1) * p
        keys = {tuple(F.key(x) for x in q): n for n, q in enumerate(four)}
        index = np.array([keys[tuple(F.key(x) for x in q.coordinates)] for q in p])
        assert index.tolist() == list(range(len(four)))
        if name == "GF(4)":  # the formula on all pairs by galois, in one go
            w, x, y, z = p.coordinates
            c = [F.array(s) for s in A.constants]
            rows = tuple(s.reshape(-1, 1) for s in (w, x, y, z))
            expected = multiply(type(A.constants)(*c), rows, (w, x, y, z))
            assert all((u == v).all() for u, v in zip(table.coordinates, expected, strict=True))
        else:
            labels = table.to_array().reshape(4, -1).T.tolist()
            pairs = cartesian(four, repeat=2)
            for found, (u, v) in zip(labels, pairs, strict=True):
                assert found == [F.label(s) for s in multiply(A.constants, u, v)]


SIZES = [0, 1, 2**15, 2**21, 2**30 - 1, 2**30, 2**31, 2**32, 2**62, 2**63 - 1, 2**63, 2**64, 2**100]


@pytest.mark.parametrize("size", share_quick(SIZES[::-1], 3))
@pytest.mark.parametrize("name", ["ZZ", "QQ"])
def test_words_that_overflow(name, size):
    F, rng = ring(name), Random(size)
    kinds = ((-1, -1, 0), (-1, -3, 0), (2, -3, 1), (10**5, -(10**6), 3), (2**63, 1, 0))
    turn = SIZES.index(size) + 2 * (name == "QQ")
    for a, b, t in kinds if THOROUGH else (kinds[turn % 5], kinds[(turn + 1) % 5]):
        P, Q = (
            [
                tuple(
                    F(rng.choice((rng.randint(-size, size), size, -size, 0, 1))) for _ in range(4)
                )
                for _ in range(10)
            ]
            for _ in range(2)
        )
        agrees(QuaternionAlgebra(F, a, b, t), P, Q)


ENDS = sorted({s * (2**n + d) for n in (7, 15, 31, 63) for d in (-2, -1, 0, 1) for s in (1, -1)})


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(4))
def test_whole_numbers_at_the_ends_of_every_width(seed):
    """Arrays of one width each, every one with every other, and the widths themselves."""
    F, rng = ring("ZZ"), Random(seed)
    a, b, t = ((-1, -1, 0), (-1, -3, 0), (2, 127, -128), (2**31 - 1, -(2**31), 1))[seed]
    A = QuaternionAlgebra(F, a, b, t)
    rows = []
    for bits in (7, 8, 15, 16, 31, 32, 62, 63, 64):
        most = [x for x in ENDS if abs(x) < 2**bits] + [0, 1, -1, 2**bits - 1, 1 - 2**bits]
        four = [tuple(F(rng.choice(most)) for _ in range(4)) for _ in range(12)]
        four[3] = (F(2**bits - 1),) * 4
        four[4] = (F(1 - 2**bits),) * 4
        rows.append(four)
        dtype = A(*map(list, zip(*four, strict=True)))._stored[0].dtype
        assert (
            dtype.kind == "O" if bits > 63 else 8 * dtype.itemsize > bits > 4 * dtype.itemsize - 1
        )
    for P in rows:
        for Q in rng.sample(rows, 3):
            agrees(A, P, Q)


@subcases("x", [*ENDS, 0])
def test_a_whole_number_is_the_same_in_every_width(x):
    A = H("ZZ")
    texts, numbers = A([str(x), "1"], 0, 0, 0), [A(x, 0, 0, 0), A(1, 0, 0, 0)]
    for q in (texts, A([x, 1], 0, 0, 0), A([2**64, x, 1], 0, 0, 0)[1:], texts + 2**70 - 2**70):
        assert (q == texts).all()
        assert [hash(n) for n in q] == [hash(n) for n in numbers]
        assert [int(n) for n in (-q).coordinates[0]] == [-x, -1]
        assert [int(n) for n in q.trace()] == [2 * x, 2]
        assert [int(n) for n in q.conjugate().norm()] == [x * x, 1]
        assert (pickle.loads(pickle.dumps(q)) == q).all()
    for dtype in ("i1", "u1", "i2", ">i2", "i4", "u4", "i8", "u8"):
        info = np.iinfo(dtype)
        if info.min <= x <= info.max and x < 2**63:
            q = A.from_array(np.array([[x, 1], [0, 0], [0, 0], [0, 0]], dtype))
            assert (q == texts).all()
            assert [int(n) for n in (q * q).coordinates[0]] == [x * x, 1]


@pytest.mark.parametrize("size", [9, 2**20, 2**31, 2**63, 2**70])
def test_fractions(size):
    F, rng = ring("QQ"), Random(size)
    for a, b, t in (("-1", "-1", 0), ("-1/2", "-3/5", 0), ("1/3", "-2", "1/7")):
        P, Q = (
            [
                tuple(
                    F(rng.randint(-size, size)) / rng.choice((1, 2, 3, 5, size)) for _ in range(4)
                )
                for _ in range(10)
            ]
            for _ in range(2)
        )
        agrees(QuaternionAlgebra(F, F(a), F(b), F(t)), P, Q)


@pytest.mark.parametrize("least", [-(2**63), 2**63 - 1])
def test_the_ends_of_a_word(least):
    A = H("ZZ")
    q = A([least, 1], 0, 0, 0)
    assert [int(x) for x in (q + q).coordinates[0]] == [2 * least, 2]
    assert [int(x) for x in (-q).coordinates[0]] == [-least, -1]
    assert [int(x) for x in (q * q).coordinates[0]] == [least * least, 1]
    assert ((q * q) - (q * q)).is_zero().all()
    assert [int(x) for x in q.norm()] == [least * least, 1]


def test_wide_and_narrow_forms_of_one_array_are_equal():
    for name in ("ZZ", "QQ"):
        A = H(name)
        q = A([1, -2, 3], [5, 6, 7], 0, -1)
        big = A([2**70, 2**80, 1], 1, 2, 3)
        back = q + big - big
        assert (back == q).all()
        assert (q == back).all()
        assert (pickle.loads(pickle.dumps(big)) == big).all()
        assert hash(back[1]) == hash(q[1])


# --- shapes and strides ---------------------------------------------------------------------

SHAPES = [(), (1,), (5,), (2, 3), (1, 3), (2, 1), (0,), (2, 0), (4, 1, 3)]


@settings(max_examples=60, deadline=None)
@given(
    name=st.sampled_from(["GF(7)", "GF(2^8)", "ZZ", "QQ"]),
    shapes=st.tuples(st.sampled_from(SHAPES), st.sampled_from(SHAPES)),
    steps=st.tuples(st.sampled_from([1, 2, -1, -3]), st.sampled_from([1, 2, -1])),
    seed=st.integers(0, 10**6),
)
def test_every_shape_and_stride(name, shapes, steps, seed):
    A, rng = H(name), np.random.default_rng(seed)
    arrays = []
    for shape, step in zip(shapes, steps, strict=True):
        wide = shape if not shape else (*shape[:-1], shape[-1] * abs(step))
        block = A(*(rng.integers(0, 7, wide) for _ in range(4)))
        arrays.append(block if not shape else block[..., ::step])
    p, q = arrays
    try:
        shape = np.broadcast_shapes(p.shape, q.shape)
    except ValueError:
        with pytest.raises(CoercionError, match="shapes"):
            p * q
        return
    found = p * q
    assert found.shape == shape
    if not found.shape:
        assert found == p * q
        return
    w, x = (
        np.broadcast_to(np.arange(np.prod(a.shape, dtype=int)).reshape(a.shape), shape)
        for a in (p, q)
    )
    u, v = (a.reshape(-1) if a.shape else None for a in (p, q))
    for index in np.ndindex(*shape):
        left, right = (a if b is None else b[int(n[index])] for a, b, n in ((p, u, w), (q, v, x)))
        assert found[index] == left * right


@pytest.mark.parametrize("name", ["GF(7)", "ZZ"])  # a result over ZZ is wider than the operands
@pytest.mark.parametrize("number", [2, 3, 7])
@pytest.mark.parametrize("count", [1, 500, 501, 699, 700, 701, 1001, 2048])
def test_threads_share_long_arrays(name, number, count, monkeypatch):
    """Stretches that divide the length or not, in pieces that divide a stretch or not."""
    A, rng = H(name), np.random.default_rng(1)
    p, q = (A.from_array(rng.integers(0, 7, (4, count), dtype=np.uint8)) for _ in range(2))
    alone = p * q, p * q[0]
    for limit, size in (("THREADED_ELEMENTS", 500), ("ELEMENTS_PER_THREAD", 100), ("PIECE", 64)):
        monkeypatch.setattr(calling, limit, size)
    before = threads()
    try:
        threads(number)
        shared = p * q, p * q[0]
    finally:
        threads(before)
    assert all((x == y).all() for x, y in zip(alone, shared, strict=True))


# --- methods of arrays alone ----------------------------------------------------------------


@subcases("name", ["GF(7)", "GF(2^64)", "QQ", "ZZ", "QQ(sqrt(2))", "RDF"])
@subcases("count", [1, 2, 3, 7, 8, 13])
def test_sums_and_ordered_products(name, count):
    A, rng = H(name), Random(count)
    each = [A(*(rng.randint(-2, 2) for _ in range(4))) for _ in range(2 * count)]
    columns = [[q.coordinates[n] for q in each] for n in range(4)]
    p = A(*columns)
    in_order = total = None
    for q in each:
        in_order = q if in_order is None else in_order * q
        total = q if total is None else total + q
    assert p.product() == A.product(p) == A.product(each) == in_order
    assert p.sum() == total
    table = p.reshape(2, count)
    assert table.product() == in_order
    rows = table.product(axis=1)
    assert rows.shape == (2,)
    assert rows[0] * rows[1] == in_order
    assert (table.sum(0) == p[:count] + p[count:]).all()
    assert A.product([]) == 1
    assert A([], 0, 0, 0).product() == 1
    assert A([], 0, 0, 0).sum() == 0
    with pytest.raises(CoercionError, match="no axis 2"):
        table.sum(2)
    with pytest.raises(CoercionError, match="single quaternion"):
        each[0].sum()


@pytest.mark.parametrize("name", share_quick(["ZZ", "QQ", *FINITE], 4))
def test_arrays_of_integers_go_out_and_in(name, tmp_path):
    F, rng = ring(name), Random(name)
    A = QuaternionAlgebra(F, F.random(rng), F.random(rng))
    q = A(*map(list, zip(*elements(F, rng, 12), strict=True))).reshape(3, 4)
    block = q.to_array()
    assert block.shape[1:] == (3, 4)
    np.save(tmp_path / "q.npy", block)
    for again in (
        A.from_array(np.load(tmp_path / "q.npy")),
        A.from_array(block.astype(np.int64) if block.max() < 2**63 else block),
        pickle.loads(pickle.dumps(q)),
        copy.deepcopy(q),
    ):
        assert again.shape == (3, 4)
        assert (again == q).all()
    assert (A.from_array(q[::-1].to_array()) == q[::-1]).all()
    product = q * q
    assert (A.from_array(product[::-1].to_array()) == product[::-1]).all()
    if name == "ZZ":  # stored in 16 bits; given as int64 they stay that wide
        product = A.from_array(product.to_array())
        assert product.to_array().dtype == np.int64
    assert np.shares_memory(product.to_array(), product.to_array())
    assert not np.shares_memory(A.from_array(product.to_array()).to_array(), product.to_array())


def test_what_stands_for_no_elements_is_refused():
    A = H("GF(7)")
    for wrong in (
        np.full((4, 2), 7),
        np.full((4, 2), -1),
        np.zeros((3, 2), int),
        np.zeros((4, 2)),
        5,
    ):
        with pytest.raises(CoercionError):
            A.from_array(wrong)
    with pytest.raises(CoercionError, match="denominator"):
        H("QQ").from_array(np.zeros((5, 2), int))
    with pytest.raises(CoercionError, match="64 bits"):
        H("ZZ")([2**64], 0, 0, 0).to_array()
    with pytest.raises(CoercionError, match="no form of integers"):
        H("RR")([1], 0, 0, 0).to_array()


@pytest.mark.slow
def test_arrays_of_galois_are_copied():
    for order, name in ((7, "GF(7)"), (256, "GF(2^8)"), (243, "GF(3^5)")):
        field = galois_class(order)
        A = H(name)
        four = [field.Random(5, seed=n) for n in range(4)]
        q = A(*four)
        assert not any(np.shares_memory(x, y) for x, y in zip(four, q.coordinates, strict=True))
        assert all((x == y).all() for x, y in zip(four, q.coordinates, strict=True))
        assert all(type(x) is type(y) for x, y in zip(four, q.coordinates, strict=True))
        assert [int(x) for x in (q * q).coordinates[0]] == [
            int(x)
            for x in multiply(type(A.constants)(*map(A.ring.array, A.constants)), four, four)[0]
        ]


# --- arithmetics ------------------------------------------------------------------------------


@pytest.mark.parametrize(("p", "n"), first_quick([(3, 2), (3, 5), (5, 4), (7, 3)], 2))
def test_logarithms_and_polynomials_say_the_same_as_galois(p, n):
    field = galois_class(p**n)
    F = ring(f"GF({p}^{n})")
    arithmetic = LogarithmicField(p, tuple(F.coefficients), int(field.primitive_element))
    logarithms, powers, _ = arithmetic.tables()
    exponents = np.arange(p**n - 1)
    labels = np.array(field.primitive_element**exponents)
    assert (logarithms[labels] == exponents).all()
    assert not powers[2 * (p**n - 1) :].any()
    with pytest.raises(ValueError, match="does not generate"):
        LogarithmicField(p, tuple(F.coefficients), 1).tables()
    assert PolynomialArithmetic(p, tuple(F.coefficients)).dtype == arithmetic.dtype


@pytest.mark.slow
def test_without_machine_code_the_values_are_the_same():
    code = (
        "from hfield import H\n"
        "from hfield.compiling import machine_code\n"
        "found = []\n"
        "for name in ('GF(9)', 'ZZ/6', 'ZZ', 'QQ'):\n"
        "    A = H(name); p = A([1, 2, 3], [4, 5, 1], 2, [1, 0, 2]); q = A(1, [2, 5, 1], 0, 3)\n"
        "    found += [p * q, p + q, p - q, -p, p.conjugate(), p ** 3, p * 2, (p * q).sum()]\n"
        "print(machine_code.available(), [str(x[n]) if hasattr(x, 'shape') and x.shape else str(x)\n"
        "    for x in found for n in range(3)])"
    )
    compiled, plain = (
        subprocess.run(
            [sys.executable, "-c", code],
            capture_output=True,
            text=True,
            check=True,
            env={**__import__("os").environ, "NUMBA_DISABLE_JIT": flag},
        ).stdout.split(" ", 1)
        for flag in ("0", "1")
    )
    assert (compiled[0], plain[0]) == ("True", "False")
    assert compiled[1] == plain[1]


@pytest.mark.slow
def test_products_over_finite_fields_import_neither_galois_nor_numba():
    code = (
        "import sys; from hfield import H\n"
        "for name in ('GF(7)', 'GF(2^8)', 'GF(3^5)', 'GF(2^64)'):\n"
        "    A = H(name); q = A([1, 2, 4], 1, 0, 2); p = (q * q + 1).conjugate(); p == q; str(p[0])\n"
        "    p.sum(); A.from_array(p.to_array()); (p[:1] * p)\n"
        "print({'galois', 'numba', 'sympy'} & set(sys.modules))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "set()"


def test_a_word_is_said_on_terminals_only(capsys, monkeypatch):
    announcer = machine_code.Announcer("compiling")
    announcer()
    assert capsys.readouterr().err == ""
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True, raising=False)
    announcer()
    announcer()
    assert capsys.readouterr().err == "compiling\n"
