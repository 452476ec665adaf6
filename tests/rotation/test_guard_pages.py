"""No kernel touches memory that is not an operand's: arrays lie flush against pages that none may touch."""

import subprocess
import sys

import pytest

from tests.patience import PATIENCE

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="needs mmap and mprotect of Linux")

SCRIPT = """
import ctypes, mmap
import numpy as np
from rotation import kernels

PAGE, GUARD = mmap.PAGESIZE, 64 * mmap.PAGESIZE
libc = ctypes.CDLL(None, use_errno=True)
kept = []

def guarded(shape, at_end):
    size = int(np.prod(shape)) * 8
    room = -(-size // PAGE) * PAGE
    memory = mmap.mmap(-1, room + 2 * GUARD)
    first = ctypes.addressof(ctypes.c_char.from_buffer(memory))
    for start in (first, first + GUARD + room):
        assert libc.mprotect(ctypes.c_void_p(start), ctypes.c_size_t(GUARD), 0) == 0
    kept.append(memory)
    offset = GUARD + (room - size if at_end else 0)
    return np.frombuffer(memory, np.float64, size // 8, offset).reshape(shape)

def one_row(n, k, at_end):
    row = guarded((1, k), at_end)
    row[...] = 1.0
    return np.broadcast_to(row, (n, k))

LAYOUTS = {
    "rows": lambda n, k, e: guarded((n, k), e),
    "columns": lambda n, k, e: guarded((k, n), e).T,
    "rows backwards": lambda n, k, e: guarded((n, k), e)[::-1],
    "columns backwards": lambda n, k, e: guarded((k, n), e).T[::-1],
    "components backwards": lambda n, k, e: guarded((n, k), e)[:, ::-1],
    "every other row": lambda n, k, e: guarded((2 * n - 1, k), e)[::2],
    "one row for all": one_row,
}
rng = np.random.default_rng(3)
for n in (*range(1, 18), 2047, 2049):
    for name, layout in LAYOUTS.items():
        for at_end in (False, True):
            def made(k):
                array = layout(n, k, at_end)
                if array.flags.writeable:
                    array[...] = rng.normal(size=(n, k))
                return array
            points, axes, turns, angles = made(3), made(3), made(4), made(1)[:, 0]
            out = made(3) if points.flags.writeable else guarded((n, 3), at_end)
            kernels.one(points, np.eye(3), out)
            np.testing.assert_array_equal(out, points)
            kernels.axis_angle(points, axes, angles, out)
            kernels.quaternions(points, turns, out)
            kernels.euler(points, axes, (2, 1, 0), True, out)
            if points.flags.writeable:
                kernels.axis_angle(points, axes, angles * 1e12, points)
    kept.clear()
print("untouched")
"""


@pytest.mark.slow
def test_no_kernel_reads_or_writes_beside_its_arrays() -> None:
    done = subprocess.run(
        [sys.executable, "-c", SCRIPT],
        capture_output=True,
        text=True,
        timeout=PATIENCE,
        check=False,
    )
    assert done.stdout.strip() == "untouched", done.stderr[-2000:]
