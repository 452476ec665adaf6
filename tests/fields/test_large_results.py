"""Results of many megabytes: memory that is used again, and stores past the caches."""

import gc
from collections import deque
from threading import Thread

import numpy as np
import pytest

from hfield import H, Quaternion
from hfield.compiling import loops, machine_code, memory
from tests.subcases import first_quick

pytestmark = pytest.mark.skipif(
    not machine_code.available(), reason="there is nothing to compile with"
)


@pytest.fixture(autouse=True)
def small(monkeypatch: pytest.MonkeyPatch) -> None:
    """Call large what is quickly made, and begin with nothing kept."""
    monkeypatch.setattr(memory, "POOLED_BYTES", 64)
    monkeypatch.setattr(memory, "KEPT", 1 << 20)
    monkeypatch.setattr(memory, "_kept", deque())


def drawn(count: int, bits: int = 20, seed: int = 1) -> Quaternion:
    most, rng = 1 << bits, np.random.default_rng(seed)
    return H("ZZ")(*(rng.integers(1 - most, most, count) for _ in range(4)))


def place(q: Quaternion) -> int:
    address: int = q._stored[0].__array_interface__["data"][0]
    return address


@pytest.mark.slow
def test_memory_is_used_again_when_nobody_holds_it() -> None:
    p, q = drawn(1000), drawn(1000, seed=2)
    first = p * q
    values, where = first.to_array().copy(), place(first)  # to_array() shares the memory
    row = first._stored[2]
    del first
    gc.collect()
    other = q * p
    assert place(other) != where  # a row of the first is still referenced
    assert (row == values[2]).all()
    del row
    gc.collect()
    again = p * q
    assert place(again) == where
    assert (again.to_array() == values).all()
    assert (other.to_array() != values).any()


def test_what_is_kept_is_bounded() -> None:
    p = drawn(4000)  # 128 000 bytes a product
    stored = [p * p for _ in range(20)]
    assert len({place(q) for q in stored}) == 20
    del stored
    gc.collect()
    assert sum(m.nbytes for m in memory._kept) <= memory.KEPT
    assert len(memory._kept) == memory.KEPT // 128_000
    kept = len(memory._kept)
    short = drawn(40) * drawn(40)  # much shorter ones do not take it
    assert len(memory._kept) == kept
    assert (
        memory.block((1, memory.KEPT + 1), "u1")[0].base is None
    )  # larger ones are not lent at all
    del short


def test_threads_do_not_get_the_same_memory() -> None:
    operands = [drawn(3000, seed=n) for n in range(4)]
    wanted = [(p * p).to_array() for p in operands]
    wrong = list[int]()

    def work(n: int) -> None:
        for _ in range(60):
            if not ((operands[n] * operands[n]).to_array() == wanted[n]).all():
                wrong.append(n)

    threads = [Thread(target=work, args=(n,)) for n in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not wrong


@pytest.mark.parametrize("bits", first_quick([29, 7, 15, 20], 1))
def test_what_is_written_past_the_caches_is_the_same(bits: int) -> None:
    """Lengths around those of lines and blocks, rows that begin anywhere in a line."""
    lines = [1, 2, 3, 7, 8, 9, 63, 64, 65]
    block = loops.BLOCK
    for count in (*lines, *(block + n for n in (-1, 0, 1)), 3 * block + 5):
        p, q = drawn(count, bits), drawn(count, bits, seed=3)
        x, y = p.to_array(), q.to_array()
        wanted = [hamilton(x, y), x + y, -x, 3 * x]
        for _ in range(2):  # the second time in memory that was used
            for found, right in zip((p * q, p + q, -p, p * 3), wanted, strict=True):
                assert (found.to_array() == right).all(), count
            del found
            for used in memory._kept:
                used[:] = 0xA5


@pytest.mark.parametrize("name", ["QQ", "GF(7)", "GF(9)", "GF(2^8)"])
def test_other_rings_use_memory_again(name: str) -> None:
    A, rng, count = H(name), np.random.default_rng(5), loops.BLOCK + 3
    p, q = (A(*(rng.integers(-6, 7, count) for _ in range(4))) for _ in range(2))
    wanted = [p[n] * q[n] + p[n] for n in range(0, count, 40)]
    for _ in range(3):
        found = p * q + p
        assert all(found[40 * n] == right for n, right in enumerate(wanted))
        del found
        assert memory._kept


@pytest.mark.parametrize("where", [0, loops.BLOCK, 3 * loops.BLOCK - 1])
def test_an_overflow_in_any_block_is_noticed(where: int) -> None:
    numbers = np.ones(3 * loops.BLOCK, np.int64)
    numbers[where] = 2**40
    p = H("ZZ")(numbers, 0, 0, 0)
    for _ in range(3):  # at last in memory that was used
        product = p * p
        assert product[where] == 2**80
        assert product[where - 1] == 1


def hamilton(p: np.ndarray, q: np.ndarray) -> np.ndarray:
    """Multiply as one types it."""
    (a, b, c, d), (e, f, g, h) = p, q
    return np.stack(
        [
            a * e - b * f - c * g - d * h,
            a * f + b * e + c * h - d * g,
            a * g - b * h + c * e + d * f,
            a * h + b * g - c * f + d * e,
        ]
    )
