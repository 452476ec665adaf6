"""Running products of unit quaternions in twice the precision.

A plain product of a million quaternions drifts: at random, or steadily if one factor is repeated. Here each
component of the running product, and of each normalised factor, is a sum of two floats, high and low. So
rounding occurs at the 106th bit, and once more when a result is stored.
"""

import ctypes
from functools import cache

import numpy as np

from hfield.compiling import machine_code
from hfield.compiling.instructions import module
from rotation.array_types import Array
from rotation.coordinates import middling
from rotation.kernels import numpy_kernels
from rotation.native import builtins, tracing
from rotation.native.pairs import Pair, two_product, two_sum
from rotation.native.symbols import Lanes, RowFunction

Pairs = tuple[Pair, Pair, Pair, Pair]


def cumulative(q: Array) -> Array:
    """Return the running products of the rows of ``q`` (N, 4), each new factor on the left, normalised."""
    loop = _loop()
    if loop is None:
        return numpy_kernels.cumulative(q)
    out = np.empty_like(q)
    table = (ctypes.c_int64 * 2)(q.ctypes.data, out.ctypes.data)
    loop(len(q), ctypes.addressof(table))
    return out


@cache
def _loop() -> machine_code.Function | None:
    if not machine_code.available():
        return None
    with machine_code.lock:
        builtins.register_symbols()
        return machine_code.function(machine_code.compiled(module(_entry()), "entry"))


def _entry() -> RowFunction:
    """Write the function ``entry(n, addresses)``, which processes the rows one after another in scalars."""
    program = RowFunction("i64 @entry(i64 %n, ptr %addresses)", width=1)
    kind = program.kind
    factors, products = program.entries("ptr", "%addresses", 2)

    def turn(i: str, *running: str) -> list[str]:
        row = program.value(f"mul i64 {i}, 4")
        start, end = (program.at("double", rows, row) for rows in (factors, products))
        numbers = (program.load(kind, program.at("double", start, k), 8) for k in range(4))
        factor = tracing.as_arrays(Lanes(program, x) for x in numbers)
        parts = iter(tracing.as_arrays(Lanes(program, x) for x in running))
        w, x, y, z = zip(parts, parts, strict=True)
        a, b, c, d = _normalised(tuple((f, f * 0.0) for f in middling(tracing.NAMESPACE, factor)))
        product = _normalised(
            (
                _sum(
                    _product(a, w),
                    _minus(_product(b, x)),
                    _minus(_sum(_product(c, y), _product(d, z))),
                ),
                _sum(_product(a, x), _product(b, w), _sum(_product(c, z), _minus(_product(d, y)))),
                _sum(_product(a, y), _minus(_product(b, z)), _sum(_product(c, w), _product(d, x))),
                _sum(_product(a, z), _product(b, y), _sum(_minus(_product(c, x)), _product(d, w))),
            )
        )
        for k, high in enumerate(tracing.as_lanes(high for high, _ in product)):
            program.store(kind, high.name, program.at("double", end, k), 8)
        return [part.name for pair in product for part in tracing.as_lanes(pair)]

    first = [(kind, program.constant(x)) for x in (1.0, *[0.0] * 7)]
    program.loop("0", "%n", turn, first=first)
    program.end("i64 0")
    return program


def _sum(a: Pair, b: Pair, *more: Pair) -> Pair:
    s, e = two_sum(a[0], b[0])
    t, f = two_sum(a[1], b[1])
    s, e = _settled(s, e + t)
    found = _settled(s, e + f)
    return _sum(found, *more) if more else found


def _product(a: Pair, b: Pair) -> Pair:
    p, e = two_product(tracing.NAMESPACE, a[0], b[0])
    return _settled(p, e + (a[0] * b[1] + a[1] * b[0]))


def _settled(high: Array, low: Array) -> Pair:
    """Return a pair whose low part is below one unit in the last place of the high part."""
    s = high + low
    return s, low - (s - high)


def _minus(a: Pair) -> Pair:
    return -a[0], -a[1]


def _normalised(q: tuple[Pair, ...]) -> Pairs:
    """Return four pairs divided by their length, which must lie between 2⁻²⁰⁰ and 2²⁰⁰."""
    w, x, y, z = q
    square = _sum(_product(w, w), _product(x, x), _sum(_product(y, y), _product(z, z)))
    # Newton: from r ≈ 1/√square in one precision to twice that
    r = 1.0 / tracing.NAMESPACE.sqrt(square[0])
    zero = 0.0 * r
    guess = (r, zero)
    rest = _sum((zero + 1.0, zero), _minus(_product(square, _product(guess, guess))))
    factor = _sum(guess, _product((0.5 * r, zero), rest))
    return _product(w, factor), _product(x, factor), _product(y, factor), _product(z, factor)
