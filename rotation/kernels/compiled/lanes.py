"""Eight numbers at a time: a type of numba's that is one SIMD vector, with the operators of a number.

A formula written for numbers then works on eight points at once, whatever a compiler would have made of
its loop. Eight float64 are one register of AVX-512; elsewhere LLVM takes as many as they need. Products
and sums may be fused (FMA), nothing else is rearranged.
"""

import math
import operator
from collections.abc import Callable
from typing import Any

from llvmlite import ir
from numba import types
from numba.core import cgutils
from numba.extending import lower_builtin, models, register_model, type_callable

from rotation.kernels.compiled.compiling import primitive

GROUP = 8
ALL = 2**GROUP - 1  # the bits of a condition that holds in every lane

_FLAGS = ("contract",)
_INDEX = ir.IntType(32)
_BITS = ir.VectorType(ir.IntType(64), GROUP)
_LOGICAL = ir.VectorType(ir.IntType(1), GROUP)


class Lanes(types.Type):  # type: ignore[misc]
    """Eight numbers of one float type."""

    def __init__(self, dtype: Any) -> None:
        self.dtype = dtype
        super().__init__(f"Lanes({dtype})")


class Mask(types.Type):  # type: ignore[misc]
    """Eight truth values."""

    def __init__(self) -> None:
        super().__init__("Mask")


mask = Mask()


def _vector(lanes: Any) -> Any:
    return ir.VectorType(_scalar(lanes.dtype), GROUP)


def _scalar(dtype: Any) -> Any:
    return ir.DoubleType() if dtype == types.float64 else ir.FloatType()


@register_model(Lanes)
class _LanesModel(models.PrimitiveModel):  # type: ignore[misc]
    def __init__(self, manager: Any, kind: Any) -> None:
        super().__init__(manager, kind, _vector(kind))


@register_model(Mask)
class _MaskModel(models.PrimitiveModel):  # type: ignore[misc]
    def __init__(self, manager: Any, kind: Any) -> None:
        super().__init__(manager, kind, _LOGICAL)


def _shuffled(builder: Any, a: Any, b: Any, places: list[int]) -> Any:
    return builder.shuffle_vector(a, b, ir.Constant(ir.VectorType(_INDEX, len(places)), places))


def _wide(context: Any, builder: Any, kind: Any, value: Any, lanes: Any) -> Any:
    """Return the operand as lanes: a number stands for eight of the same."""
    if isinstance(kind, Lanes):
        return value
    number = context.cast(builder, value, kind, lanes.dtype)
    empty = ir.Constant(_vector(lanes), ir.Undefined)
    first = builder.insert_element(empty, number, _INDEX(0))
    return _shuffled(builder, first, empty, [0] * GROUP)


def _operands(context: Any, builder: Any, signature: Any, args: Any) -> list[Any]:
    lanes = next(kind for kind in signature.args if isinstance(kind, Lanes))
    return [_wide(context, builder, k, v, lanes) for k, v in zip(signature.args, args, strict=True)]


def _binary(operation: Any, code: Callable[[Any, Any, Any], Any], logical: bool = False) -> None:
    """Teach numba ``operation`` between lanes, and between lanes and a number."""

    @type_callable(operation)  # type: ignore[untyped-decorator]
    def typing(context: Any) -> Any:
        def typer(a: Any, b: Any) -> Any:
            for one, other in ((a, b), (b, a)):
                if isinstance(one, Lanes) and (other == one or isinstance(other, types.Number)):
                    return mask if logical else one
            return None

        return typer

    def lower(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        return code(builder, *_operands(context, builder, signature, args))

    for kinds in ((Lanes, Lanes), (Lanes, types.Number), (types.Number, Lanes)):
        lower_builtin(operation, *kinds)(lower)


_binary(operator.add, lambda builder, a, b: builder.fadd(a, b, flags=_FLAGS))
_binary(operator.sub, lambda builder, a, b: builder.fsub(a, b, flags=_FLAGS))
_binary(operator.mul, lambda builder, a, b: builder.fmul(a, b, flags=_FLAGS))
_binary(operator.truediv, lambda builder, a, b: builder.fdiv(a, b, flags=_FLAGS))
_binary(operator.le, lambda builder, a, b: builder.fcmp_ordered("<=", a, b), logical=True)
_binary(operator.ge, lambda builder, a, b: builder.fcmp_ordered(">=", a, b), logical=True)
_binary(operator.lt, lambda builder, a, b: builder.fcmp_ordered("<", a, b), logical=True)
_binary(operator.gt, lambda builder, a, b: builder.fcmp_ordered(">", a, b), logical=True)
_binary(operator.ne, lambda builder, a, b: builder.fcmp_unordered("!=", a, b), logical=True)


def _unary(operation: Any, code: Callable[[Any, Any], Any]) -> None:
    """Teach numba ``operation`` on lanes."""

    @type_callable(operation)  # type: ignore[untyped-decorator]
    def typing(context: Any) -> Any:
        return lambda a: a if isinstance(a, Lanes) else None

    @lower_builtin(operation, Lanes)  # type: ignore[untyped-decorator]
    def lower(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        return code(builder, args[0])


def _by_llvm(name: str) -> Callable[[Any, Any], Any]:
    def code(builder: Any, a: Any) -> Any:
        letter = "f64" if isinstance(a.type.element, ir.DoubleType) else "f32"
        function = ir.FunctionType(a.type, (a.type,))
        full = f"llvm.{name}.v{GROUP}{letter}"
        return builder.call(cgutils.get_or_insert_function(builder.module, function, full), [a])

    return code


_unary(operator.neg, lambda builder, a: builder.fneg(a))
_unary(math.sqrt, _by_llvm("sqrt"))
_unary(abs, _by_llvm("fabs"))


def _between_masks(operation: Any, number: int, name: str) -> None:
    """Teach numba a logical operation on a number of masks."""

    @type_callable(operation)  # type: ignore[untyped-decorator]
    def typing(context: Any) -> Any:
        if number == 1:
            return lambda a: mask if isinstance(a, Mask) else None
        return lambda a, b: mask if isinstance(a, Mask) and isinstance(b, Mask) else None

    @lower_builtin(operation, *[Mask] * number)  # type: ignore[untyped-decorator]
    def lower(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        return getattr(builder, name)(*args)


_between_masks(operator.and_, 2, "and_")
_between_masks(operator.or_, 2, "or_")
_between_masks(operator.invert, 1, "not_")


@primitive
def where(context: Any, condition: Any, a: Any, b: Any) -> Any:
    """Return lanes of ``a`` where the condition holds, else of ``b``."""

    def code(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        return builder.select(*args)

    return a(condition, a, b), code


@primitive
def bits(context: Any, condition: Any) -> Any:
    """Return a number whose bit k tells whether the condition, of lanes or one for all, holds in lane k."""

    def code(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        together, number = ir.IntType(GROUP), ir.IntType(64)
        if isinstance(condition, Mask):
            return builder.zext(builder.bitcast(args[0], together), number)
        return builder.select(args[0], number(ALL), number(0))

    return types.int64(condition), code


@primitive
def bit(context: Any, a: Any, number: Any) -> Any:
    """Tell of each lane of float64 whether bit ``number`` of its memory is set."""
    if not isinstance(number, types.IntegerLiteral):
        return None

    def code(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        chosen = ir.Constant(_BITS, [1 << number.literal_value] * GROUP)
        found = builder.and_(builder.bitcast(args[0], _BITS), chosen)
        return builder.icmp_unsigned("!=", found, ir.Constant(_BITS, [0] * GROUP))

    return mask(a, number), code


def _converted(builder: Any, value: Any, kind: Any) -> Any:
    """Return a vector of numbers as one of another float type."""
    if value.type.element == kind:
        return value
    target = ir.VectorType(kind, value.type.count)
    widens = isinstance(kind, ir.DoubleType)
    return builder.fpext(value, target) if widens else builder.fptrunc(value, target)


def _place(builder: Any, address: Any, scalar: Any, count: int) -> Any:
    return builder.inttoptr(address, ir.VectorType(scalar, count).as_pointer())


@primitive
def load(context: Any, address: Any, stored: Any, number: Any) -> Any:
    """Return eight numbers in a row of memory: of the type of ``stored``, as lanes of ``number``'s."""
    lanes = Lanes(number)

    def code(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        where = _place(builder, args[0], _scalar(stored), GROUP)
        value = builder.load(where, align=stored.bitwidth // 8)
        return _converted(builder, value, _scalar(number))

    return lanes(address, stored, number), code


@primitive
def prefetch(context: Any, address: Any) -> Any:
    """Ask for memory that will be read soon; the address need not be one of ours."""

    def code(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        pointer = ir.IntType(8).as_pointer()
        function = ir.FunctionType(ir.VoidType(), (pointer, _INDEX, _INDEX, _INDEX))
        declared = builder.module.declare_intrinsic("llvm.prefetch", (pointer,), function)
        to_read, all_caches, data = _INDEX(0), _INDEX(3), _INDEX(1)
        where = builder.inttoptr(args[0], pointer)
        builder.call(declared, [where, to_read, all_caches, data])
        return context.get_dummy_value()

    return types.void(address), code


@primitive
def store(context: Any, address: Any, stored: Any, value: Any) -> Any:
    """Write lanes to eight numbers in a row of memory, of the type of ``stored``."""

    def code(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        where = _place(builder, args[0], _scalar(stored), GROUP)
        rounded = _converted(builder, args[2], _scalar(stored))
        builder.store(rounded, where, align=stored.bitwidth // 8)
        return context.get_dummy_value()

    return types.void(address, stored, value), code


def _column(builder: Any, parts: list[Any], k: int) -> Any:
    """Return every n-th number of n vectors, from number k on, part after part."""
    n = len(parts)
    column, found = parts[0], list(range(k, GROUP, n))
    for number, part in enumerate(parts[1:], 1):
        more = range((k - number * GROUP) % n, GROUP, n)
        places = [*found, *(GROUP + place for place in more)]
        column = _shuffled(builder, column, part, places + [0] * (GROUP - len(places)))
        found = list(range(len(places)))
    return column


@primitive
def load_rows(context: Any, address: Any, width: Any, stored: Any, number: Any) -> Any:
    """Return the columns of eight rows of memory, each of ``width`` numbers side by side, as lanes."""
    if not isinstance(width, types.IntegerLiteral):
        return None
    n = width.literal_value

    def code(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        where = _place(builder, args[0], _scalar(stored), GROUP)
        parts = [
            builder.load(builder.gep(where, [_INDEX(k)]), align=stored.bitwidth // 8)
            for k in range(n)
        ]
        columns = [
            _converted(builder, _column(builder, parts, k), _scalar(number)) for k in range(n)
        ]
        return context.make_tuple(builder, signature.return_type, columns)

    return types.UniTuple(Lanes(number), n)(address, width, stored, number), code


@primitive
def store_triples(context: Any, address: Any, stored: Any, x: Any, y: Any, z: Any) -> Any:
    """Write lanes to eight rows of memory, each of three numbers side by side."""

    def code(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        x, y, z = (_converted(builder, v, _scalar(stored)) for v in args[2:])
        pairs = _shuffled(builder, x, y, list(range(2 * GROUP)))
        rest = _shuffled(builder, z, z, list(range(2 * GROUP)))
        places = [c * GROUP + row for row in range(GROUP) for c in range(3)]
        where = _place(builder, args[0], _scalar(stored), 3 * GROUP)
        builder.store(_shuffled(builder, pairs, rest, places), where, align=stored.bitwidth // 8)
        return context.get_dummy_value()

    return types.void(address, stored, x, y, z), code
