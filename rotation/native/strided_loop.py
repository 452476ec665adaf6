"""Run a formula in a loop over points with any strides, in blocks that threads share.

The loop of `builtins` is not sufficient, because points may have any strides and either precision, and may be
rotated in place. A formula has two forms. ``fast(*rows)`` returns the new coordinates and where they are
valid, or None for everywhere. ``careful(*rows)`` returns the coordinates of the other rows. The fast loop is
a separate function that calls no others, so that its values stay in registers. It returns when one of eight
rows is not valid, and is called again after the careful form has computed these rows. Eight rows are read
before they are written, so the result may be an operand.
"""

from collections.abc import Callable, Sequence
from enum import Enum
from typing import NamedTuple, cast

from hfield.compiling.instructions import Code, module, vector
from rotation.array_types import Array
from rotation.native import tracing
from rotation.native.symbols import WIDTH, LaneMask, Lanes, RowFunction, Rows

BLOCK = 512  # rows at a time; the data copied for a block stay in the nearest cache
TAKE = 16  # blocks a thread takes at a time
LINE = 64  # bytes that a processor fetches at once
AHEAD = 8 * WIDTH  # rows; so many columns at once are more than a processor foresees
WRITTEN_AHEAD = 4 * WIDTH  # rows; memory requested for writing is not fetched twice
IN_ORDER = tuple(range(WIDTH))
# For eight points in memory order, the first coordinates are at these places of three vectors, and
# the other coordinates one and two places further. In this order of the rows, selection separates
# and joins coordinates, which is faster than moving numbers.
BY_PLACES = tuple(3 * place % WIDTH for place in range(WIDTH))

Fast = Callable[..., tuple[tuple[Array, ...], Array | None]]  # formulas on symbols
Careful = Callable[..., tuple[Array, ...]]


def _symbols_of(fast: Fast, rows: Sequence[Rows]) -> tuple[tuple[Lanes, ...], LaneMask | None]:
    """Run a formula on symbols instead of arrays."""
    return cast("tuple[tuple[Lanes, ...], LaneMask | None]", fast(*rows))


class RowLayout(Enum):
    """The memory layout of the rows of an operand."""

    SIDE_BY_SIDE = "one after the other, their components side by side"
    COLUMNS = "each component in a column"
    SAME = "one row for all"
    STRIDED = "anyhow else: a block is copied to columns"


class OperandLayout(NamedTuple):
    """The static description of an array: number of components, LLVM's type of its entries, and layout."""

    width: int
    number: str
    way: RowLayout

    @property
    def size(self) -> int:
        """The bytes of a number."""
        return 8 if self.number == "double" else 4

    @property
    def step(self) -> int:
        """The number of bytes from one row to the next, in memory or in the columns to which a block is
        copied.
        """
        if self.way is RowLayout.SAME:
            return 0
        return self.size * (self.width if self.way is RowLayout.SIDE_BY_SIDE else 1)


def strided_loop(
    fast: Fast,
    careful: Careful | None,
    operands: tuple[OperandLayout, ...],
    results: int,
    number: str,
) -> str:
    """Emit the function ``entry(counter, table)``, which takes blocks from the counter until none remain.

    The table consists of 64-bit integers: the outer and the inner length of the batch, then for each operand
    its address and its strides in bytes between components, along the outer axis and along the inner axis.
    The function returns whether the careful form flagged a row.

    Parameters
    ----------
    operands : tuple of `OperandLayout`
        Those that are read, then the one that is written.
    results : int
        The number of operands that are written: 1, or 0 if the formula only returns a flag.
    number : str
        What is computed with: ``double`` or ``float``.
    """
    return module(
        *(_copy(size) for size in sorted({operand.size for operand in operands})),
        _stretch(fast, operands, results, number),
        _eight(fast, careful, operands, results, number),
        _few(operands, results),
        _entry(operands, results),
    )


def _given(operands: Sequence[object]) -> str:
    """Emit the parameters of each operand: an address, and the stride between components in bytes."""
    return "".join(f", ptr %p{n}, i64 %c{n}" for n in range(len(operands)))


def _stretch(
    fast: Fast, operands: tuple[OperandLayout, ...], results: int, number: str
) -> RowFunction:
    """Write the fast loop that starts at row ``first``; it returns the first invalid row, else ``end``."""
    head = f"internal i64 @stretch(i64 %first, i64 %end{_given(operands)}) noinline"
    program = RowFunction(head, number, fused=True)
    columns = [_columns(program, n, operand) for n, operand in enumerate(operands)]
    read = list(zip(operands, columns, strict=True))[: len(operands) - results]
    points = any(o.way is RowLayout.SIDE_BY_SIDE and o.width == 3 for o in operands)
    order = BY_PLACES if points else IN_ORDER

    def turn(i: str) -> None:
        image, right = _symbols_of(fast, [_read(program, o, c, i, order) for o, c in read])
        if right is not None:
            program.leave(program.some((~right).name), lambda: f"i64 {i}")
        if results:
            _write(program, operands[-1], columns[-1], image, i, order)

    program.loop("%first", "%end", turn, WIDTH)
    program.end("i64 %end")
    return program


def _eight(
    fast: Fast,
    careful: Careful | None,
    operands: tuple[OperandLayout, ...],
    results: int,
    number: str,
) -> RowFunction:
    """Write the function for eight rows in columns of eight; it returns whether it flagged one."""
    pointers = ", ".join(f"ptr %p{n}" for n in range(len(operands)))
    program = RowFunction(f"internal i1 @eight({pointers})", number, fused=True)
    near = [operand._replace(way=RowLayout.COLUMNS) for operand in operands]
    columns = [
        [program.at("i8", f"%p{n}", k * WIDTH * operand.size) for k in range(operand.width)]
        for n, operand in enumerate(operands)
    ]
    read = list(zip(near, columns, strict=True))[: len(near) - results]
    rows = [_read(program, o, c, "0") for o, c in read]
    image, right = _symbols_of(fast, rows)
    if right is not None and careful is not None:

        def mended() -> tuple[Lanes, ...]:
            program.flags = ""
            done = tracing.as_lanes(careful(*rows))
            return tuple(tracing.where(right, a, b) for a, b in zip(image, done, strict=True))

        image = program.rarely((~right).name, mended, image)
    if results:
        _write(program, near[-1], columns[-1], image, "0")
    flag = "false"
    for condition in program.conditions:
        flag = program.value(f"or i1 {flag}, {program.some(condition)}")
    program.end(f"i1 {flag}")
    return program


def _few(operands: tuple[OperandLayout, ...], results: int) -> Code:
    """Write the function that processes up to eight rows of any kind through a buffer.

    The last row is repeated to fill the buffer, so that each row is computed as in any other position.
    """
    code = Code(f"internal i1 @few(i64 %first, i64 %m{_given(operands)}) noinline")
    last = code.value("sub i64 %m, 1")
    buffers = [code.allocate(f"[{WIDTH * o.width * o.size} x i8]") for o in operands]
    copies = []
    for n, (o, buffer) in enumerate(zip(operands, buffers, strict=True)):
        place = code.at("i8", f"%p{n}", code.value(f"mul i64 %first, {o.step}"))
        near = f"ptr {buffer}, i64 {WIDTH * o.size}, i64 {o.size}"
        copies.append((o, near, f"ptr {place}, i64 %c{n}, i64 {o.step}"))
    for o, near, far in copies[: len(operands) - results]:
        _copied(code, o, near, far, str(WIDTH), last)
    flag = code.once(f"call i1 @eight({', '.join(f'ptr {b}' for b in buffers)})")
    for o, near, far in copies[len(operands) - results :]:
        _copied(code, o, far, near, "%m", "%m")
    code.end(f"i1 {flag}")
    return code


def _entry(operands: tuple[OperandLayout, ...], results: int) -> Code:
    """Write the iteration over the blocks."""
    code = Code("i64 @entry(ptr %counter, ptr %table)")
    v = code.value
    outer, inner, *places = code.entries("i64", "%table", 2 + 4 * len(operands))
    each = v(f"sdiv i64 {v(f'add i64 {inner}, {BLOCK - 1}')}, {BLOCK}")
    total = v(f"mul i64 {outer}, {each}")
    buffers = [
        code.allocate(f"[{BLOCK * o.size * o.width} x i8]") if o.way is RowLayout.STRIDED else ""
        for o in operands
    ]

    def least(x: str, y: str) -> str:
        return code.call("i64", "llvm.smin.i64", ("i64", x), ("i64", y))

    def turn(flag: str) -> tuple[str, list[str]]:
        begin = code.once(f"atomicrmw add ptr %counter, i64 {TAKE} monotonic")
        end = least(v(f"add i64 {begin}, {TAKE}"), total)
        (flag,) = code.loop(begin, end, block, first=[("i1", flag)])
        return v(f"icmp slt i64 {begin}, {total}"), [flag]

    def block(number: str, flag: str) -> list[str]:
        row = v(f"mul i64 {v(f'srem i64 {number}, {each}')}, {BLOCK}")
        length = least(v(f"sub i64 {inner}, {row}"), str(BLOCK))
        along = v(f"sdiv i64 {number}, {each}")
        passed, copies = list[str](), list[tuple[OperandLayout, str, str]]()
        for n, (o, buffer) in enumerate(zip(operands, buffers, strict=True)):
            start, column, step, inner_step = places[4 * n : 4 * n + 4]
            offset = v(
                f"add i64 {v(f'mul i64 {along}, {step}')}, {v(f'mul i64 {row}, {inner_step}')}"
            )
            place = v(f"inttoptr i64 {v(f'add i64 {start}, {offset}')} to ptr")
            if buffer:
                far = f"ptr {place}, i64 {column}, i64 {inner_step}"
                place, column = buffer, str(BLOCK * o.size)
                near = f"ptr {place}, i64 {column}, i64 {o.size}"
                if n < len(operands) - results:
                    _copied(code, o, near, far, length, length)
                else:
                    copies.append((o, far, near))
            passed.append(f", ptr {place}, i64 {column}")
        given = "".join(passed)
        whole = v(f"and i64 {length}, -{WIDTH}")

        def few(start: str, count: str, flag: str) -> list[tuple[str, str, str]]:
            some = code.once(f"call i1 @few(i64 {start}, i64 {count}{given})")
            return [("i1", v(f"or i1 {flag}, {some}"), flag)]

        def stretch(start: str, flag: str) -> tuple[str, list[str]]:
            i = code.once(f"call i64 @stretch(i64 {start}, i64 {whole}{given})")
            stopped = v(f"icmp slt i64 {i}, {whole}")
            (flag,) = code.when(stopped, lambda: few(i, str(WIDTH), flag))
            return stopped, [v(f"add i64 {i}, {WIDTH}"), flag]

        _, flag = code.repeat([("i64", "0"), ("i1", flag)], stretch)
        odd = v(f"sub i64 {length}, {whole}")
        (flag,) = code.when(v(f"icmp ne i64 {odd}, 0"), lambda: few(whole, odd, flag))
        for o, far, near in copies:
            _copied(code, o, far, near, length, length)
        return [flag]

    (flag,) = code.repeat([("i1", "false")], turn)
    code.end(f"i64 {v(f'zext i1 {flag} to i64')}")
    return code


# --- copies between rows anyhow and columns ------------------------------------------------------


def _copy(size: int) -> Code:
    """Write the function that copies columns of numbers of ``size`` bytes, with strides in bytes.

    Rows after ``last`` are copies of row ``last``.
    """
    strides = "ptr %to, i64 %to_column, i64 %to_row, ptr %from, i64 %from_column, i64 %from_row"
    code = Code(f"internal void @copy{size}({strides}, i64 %width, i64 %rows, i64 %last) noinline")
    v, kind = code.value, f"i{8 * size}"

    def column(k: str) -> None:
        source = code.at("i8", "%from", v(f"mul i64 {k}, %from_column"))
        target = code.at("i8", "%to", v(f"mul i64 {k}, %to_column"))

        def row(j: str) -> None:
            found = code.call("i64", "llvm.smin.i64", ("i64", j), ("i64", "%last"))
            place = code.at("i8", source, v(f"mul i64 {found}, %from_row"))
            put = code.at("i8", target, v(f"mul i64 {j}, %to_row"))
            code.store(kind, code.load(kind, place, size), put, size)

        code.loop("0", "%rows", row)

    code.loop("0", "%width", column)
    code.end()
    return code


def _copied(code: Code, operand: OperandLayout, to: str, source: str, rows: str, last: str) -> None:
    """Write a call that copies an operand's rows."""
    given = f"{to}, {source}, i64 {operand.width}, i64 {rows}, i64 {last}"
    code.do(f"call void @copy{operand.size}({given})")


# --- eight rows of an operand --------------------------------------------------------------------


def _columns(program: RowFunction, n: int, operand: OperandLayout) -> list[str]:
    """Emit the preparation of an operand before the loop: its columns, or its single row broadcast."""
    if operand.way is RowLayout.SIDE_BY_SIDE:
        return [f"%p{n}"]
    found = [
        program.at("i8", f"%p{n}", program.value(f"mul i64 %c{n}, {k}"))
        for k in range(operand.width)
    ]
    if operand.way is not RowLayout.SAME:
        return found
    numbers = (program.load(operand.number, place, operand.size) for place in found)
    return [program.spread(operand.number, x, WIDTH) for x in numbers]


def _read(
    program: RowFunction,
    operand: OperandLayout,
    columns: list[str],
    i: str,
    order: tuple[int, ...] = IN_ORDER,
) -> Rows:
    """Emit the reading of eight rows that start at row ``i``, in the given order."""
    kind = vector(operand.number, WIDTH)
    if operand.way is RowLayout.SAME:
        numbers = columns
    elif operand.way is RowLayout.SIDE_BY_SIDE:
        numbers = _parted(program, operand, columns[0], i, order)
    else:
        if i != "0":
            _ahead(program, operand, columns, i, AHEAD, writing=False)
        numbers = [
            program.load(kind, program.at(operand.number, column, i), operand.size)
            for column in columns
        ]
        numbers = [_ordered(program, kind, x, order) for x in numbers]
    lanes = [
        Lanes(program, _converted(program, x, operand.number, program.number)) for x in numbers
    ]
    return Rows((operand.width,), lanes)


def _ahead(
    program: RowFunction,
    operand: OperandLayout,
    columns: list[str],
    i: str,
    rows: int,
    writing: bool,
) -> None:
    """Prefetch the memory of eight later rows."""
    step = operand.step
    first = program.value(f"mul i64 {program.value(f'add i64 {i}, {rows}')}, {step}")
    for column in columns:
        for line in range(0, WIDTH * step, LINE):
            offset = program.value(f"add i64 {first}, {line}")
            program.ahead(program.at("i8", column, offset), writing)


def _ordered(program: RowFunction, kind: str, column: str, order: tuple[int, ...]) -> str:
    """Return a column with its rows in another order."""
    return column if order == IN_ORDER else program.shuffled(kind, column, column, order)


def _parted(
    program: RowFunction, operand: OperandLayout, base: str, i: str, order: tuple[int, ...]
) -> list[str]:
    """Emit the loads of rows with adjacent components, and their separation into columns."""
    n, number = operand.width, operand.number
    kind = vector(number, WIDTH)
    start = program.at(number, base, program.value(f"mul i64 {i}, {n}"))
    parts = [program.load(kind, program.at(kind, start, k), operand.size) for k in range(n)]
    if n == 3:  # these are the rows by places
        found = [_selected(program, kind, parts, k) for k in range(3)]
        return [_ordered(program, kind, x, _turned(k)) for k, x in enumerate(found)]
    if n != 4:
        columns = [_column(program, kind, parts, k) for k in range(n)]
        return [_ordered(program, kind, x, order) for x in columns]
    pairs = [
        program.shuffled(kind, a, b, [4 * r + c for c in pair for r in range(4)])
        for pair in ((0, 1), (2, 3))
        for a, b in (parts[:2], parts[2:])
    ]
    return [
        program.shuffled(kind, a, b, [r % 4 + 4 * c + r // 4 * WIDTH for r in order])
        for a, b in (pairs[:2], pairs[2:])
        for c in (0, 1)
    ]


def _column(program: RowFunction, kind: str, parts: list[str], k: int) -> str:
    """Return every n-th number of n vectors, starting with number k, collected vector by vector."""
    n = len(parts)
    column, found = parts[0], list(range(k, WIDTH, n))
    for number, part in enumerate(parts[1:], 1):
        more = range((k - number * WIDTH) % n, WIDTH, n)
        places = [*found, *(WIDTH + place for place in more)]
        filled = places + [0] * (WIDTH - len(places))
        column, found = program.shuffled(kind, column, part, filled), list(range(len(places)))
    return column


def _selected(program: RowFunction, kind: str, three: Sequence[str], k: int) -> str:
    """Return the vector whose lane p is the lane of vector number (p − k) mod 3 of three vectors.

    If components are adjacent, component k lies at those positions p that are p − k in its part; part k has
    at p the component p − k.
    """
    a, b, c = three
    one = [place + WIDTH * ((place - k) % 3 == 1) for place in range(WIDTH)]
    two = [place + WIDTH * ((place - k) % 3 == 2) for place in range(WIDTH)]
    return program.shuffled(kind, program.shuffled(kind, a, b, one), c, two)


def _turned(k: int) -> tuple[int, ...]:
    """Return the positions of a vector, rotated to begin with the k-th."""
    return tuple((place + k) % WIDTH for place in range(WIDTH))


def _write(
    program: RowFunction,
    operand: OperandLayout,
    columns: list[str],
    image: tuple[Lanes, ...],
    i: str,
    order: tuple[int, ...] = IN_ORDER,
) -> None:
    """Emit the writing of three coordinates of eight rows."""
    number = operand.number
    kind = vector(number, WIDTH)
    numbers = [_converted(program, x.name, program.number, number) for x in image]
    if i != "0":
        _ahead(program, operand, columns, i, WRITTEN_AHEAD, writing=True)
    if operand.way is RowLayout.SIDE_BY_SIDE:
        moved = [_ordered(program, kind, x, _turned(-k)) for k, x in enumerate(numbers)]
        start = program.at(number, columns[0], program.value(f"mul i64 {i}, 3"))
        for m in range(3):
            part = _selected(program, kind, moved, m)
            program.store(kind, part, program.at(kind, start, m), operand.size)
        return
    for x, column in zip(numbers, columns, strict=True):
        x = _ordered(program, kind, x, order)  # either order is its own inverse
        program.store(kind, x, program.at(number, column, i), operand.size)


def _converted(program: RowFunction, name: str, number: str, wanted: str) -> str:
    """Emit the conversion of eight numbers to another precision, if it differs."""
    if number == wanted:
        return name
    how = "fpext" if wanted == "double" else "fptrunc"
    return program.value(f"{how} {vector(number, WIDTH)} {name} to {vector(wanted, WIDTH)}")
