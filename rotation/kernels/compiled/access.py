"""How kernels see memory: an address and strides, in blocks taken from a counter that threads share.

One machine code then serves every layout, stride and flag of an array. An operand is a row of the
table that `rotation.kernels.memory.plan` makes: its address, then its strides counted in elements, from
one component to the next, along the outer and along the inner axis of the batch. Inside a block it
is a *view* ``(address, first element, stride between components)``, walked with a step that is best a
literal where it is called: only loops of constant stride are vectorised by the compiler.
"""

from typing import Any

from numba import types

from rotation.kernels.compiled.compiling import inlined, primitive

BLOCK = 2048  # points at a time; what is copied for a block stays in the caches
TAKE = 4  # blocks a thread takes at a time


@primitive
def take(context: Any, address: Any, step: Any) -> Any:
    """Add ``step`` to the counter at ``address`` in one atomic step; return what it was."""

    def code(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        counter = builder.inttoptr(args[0], context.get_value_type(types.int64).as_pointer())
        return builder.atomic_rmw("add", counter, args[1], "monotonic")

    return types.int64(types.int64, types.int64), code


def _pointer(context: Any, builder: Any, view: Any, args: Any, kind: Any) -> Any:
    """Return where component ``k`` of row ``i`` of a view is, for ``args = (view, step, i, k)``."""
    value, step, i, k = args
    address, first, component = (builder.extract_value(value, n) for n in range(3))
    if isinstance(view[2], types.Literal):  # known already when the loop is compiled by itself
        component = component.type(view[2].literal_value)
    base = builder.inttoptr(address, context.get_value_type(kind).as_pointer())
    exact = ("nsw",)  # no overflow: or else constant strides are not recognised
    index = builder.add(first, builder.mul(k, component, flags=exact), flags=exact)
    index = builder.add(index, builder.mul(i, step, flags=exact), flags=exact)
    return builder.gep(base, [index], inbounds=True)


@primitive
def at(context: Any, view: Any, step: Any, i: Any, k: Any, zero: Any) -> Any:
    """Return component ``k`` of row ``i`` of a view, a number of the type of ``zero``."""

    def code(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        return builder.load(_pointer(context, builder, view, args[:4], zero))

    return zero(view, types.int64, types.int64, types.int64, zero), code


@primitive
def put(context: Any, view: Any, step: Any, i: Any, k: Any, value: Any) -> Any:
    """Write component ``k`` of row ``i`` of a view."""

    def code(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        builder.store(args[4], _pointer(context, builder, view, args[:4], value))
        return context.get_dummy_value()

    return types.void(view, types.int64, types.int64, types.int64, value), code


@inlined
def blocks(outer: Any, inner: Any) -> Any:
    """Return the number of blocks of a batch."""
    return outer * ((inner + BLOCK - 1) // BLOCK)


@inlined
def span(block: Any, inner: Any) -> Any:
    """Return the outer index of a block, where it starts on the inner axis, and its length."""
    a_row = (inner + BLOCK - 1) // BLOCK
    start = (block % a_row) * BLOCK
    return block // a_row, start, min(BLOCK, inner - start)


@inlined
def packed(what: Any) -> Any:
    """Tell whether the operand holds triples, one after the other."""
    return what[1] == 1 and what[3] == 3


@inlined
def view(what: Any, outer: Any, start: Any) -> Any:
    """Return the view of an operand at a block."""
    return what[0], outer * what[2] + start * what[3], what[1]


@inlined
def near(what: Any, outer: Any, start: Any) -> Any:
    """Return the same view where the components lie side by side, as the compiler must know."""
    return what[0], outer * what[2] + start * what[3], 1
