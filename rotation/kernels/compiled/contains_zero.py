"""The kernel that looks for a zero row, one component first: most rows are cleared by that."""

from typing import Any

from rotation.kernels.compiled.access import TAKE, at, blocks, near, packed, span, take, view
from rotation.kernels.compiled.compiling import SOURCES, inlined, kernel


@inlined
def first_zero(v: Any, step: Any, m: Any, t: Any) -> Any:
    """Tell whether the first component of some row is zero."""
    found = False
    for i in range(m):
        found |= at(v, step, i, 0, t) == 0.0
    return found


@inlined
def all_zero(v: Any, step: Any, m: Any, number: Any, t: Any) -> Any:
    """Tell whether three components, and the last, of some row are zero."""
    found = False
    for i in range(m):
        some = abs(at(v, step, i, 0, t)) + abs(at(v, step, i, 1, t))
        some += abs(at(v, step, i, 2, t)) + abs(at(v, step, i, number - 1, t))
        found |= some == 0.0
    return found


@kernel
def contains_zero(
    counter: Any, outer: Any, inner: Any, table: Any, number: Any, t: Any, sources: int = SOURCES
) -> Any:
    """Tell whether some row of the operand, of three or four components, is all zero."""
    what = table[0]
    total = blocks(outer, inner)
    while True:
        first = take(counter, TAKE)
        if first >= total:
            return False
        for block in range(first, min(first + TAKE, total)):
            o, start, m = span(block, inner)
            v, step = view(what, o, start), what[3]
            if step == 1:
                if first_zero(v, 1, m, t) and all_zero(v, 1, m, number, t):
                    return True
            elif packed(what):
                if all_zero(near(what, o, start), 3, m, number, t):
                    return True
            elif first_zero(v, step, m, t) and all_zero(v, step, m, number, t):
                return True
