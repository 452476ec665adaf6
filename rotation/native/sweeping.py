"""The walk of a formula over many points, in LLVM's notation: any strides, blocks that threads share.

A formula has two forms. ``fast(*rows)`` returns the new coordinates and where they are right, or None for
everywhere. ``careful(*rows)`` returns them for the rows where they are not. The fast loop is a function by
itself that calls nothing, so that what it needs stays in registers; eight rows in which one is not right
leave it and come back. Eight rows are read before they are written, so the result may be an operand.
"""

from collections.abc import Callable
from enum import Enum
from typing import NamedTuple

from rotation.native import tracing
from rotation.native.copying import copy, copy_call
from rotation.native.tracing import WIDTH, Condition, Lanes, Program, Rows

BLOCK = 512  # rows at a time; what is copied for a block stays in the nearest cache
TAKE = 16  # blocks a thread takes at a time
LINE = 64  # bytes that a processor fetches at once
AHEAD = 8 * WIDTH  # rows; so many columns at once are more than a processor foresees
WRITTEN_AHEAD = 4 * WIDTH  # rows; memory asked for to be written is not fetched twice

Fast = Callable[..., tuple[tuple[Lanes, ...], Condition | None]]
Careful = Callable[..., tuple[Lanes, ...]]


class Way(Enum):
    """How the rows of an operand lie in memory."""

    SIDE_BY_SIDE = "one after the other, their components side by side"
    COLUMNS = "each component in a column"
    SAME = "one row for all"
    STRIDED = "anyhow else: a block is copied to columns"


class Operand(NamedTuple):
    """What a program knows of an array beforehand: components, LLVM's word for its numbers, and the way."""

    width: int
    number: str
    way: Way

    @property
    def size(self) -> int:
        """The bytes of a number."""
        return 8 if self.number == "double" else 4


def module(
    fast: Fast, careful: Careful | None, operands: tuple[Operand, ...], results: int, number: str
) -> str:
    """Write the function ``entry(counter, table)``: it takes blocks from the counter until none is left.

    The table is of 64-bit integers: the outer and the inner length of the batch, then for each operand its
    address and its strides in bytes, between components, along the outer and along the inner axis.
    The function returns whether the careful form had something to `tell`.

    Parameters
    ----------
    operands : tuple of `Operand`
        Those that are read, then the one that is written.
    results : int
        How many operands are written: 1, or 0 where the formula only tells.
    number : str
        What is computed with: ``double`` or ``float``.
    """
    sizes = sorted({operand.size for operand in operands})
    return "\n".join(
        [
            *_declarations(),
            *(copy(size) for size in sizes),
            _stretch(fast, operands, results, number),
            _eight(fast, careful, operands, results, number),
            _few(operands, results),
            _entry(operands, results),
        ]
    )


def _declarations() -> list[str]:
    lines = ["declare void @llvm.prefetch.p0(ptr, i32, i32, i32)"]
    for name, n in (("sin", 1), ("cos", 1)):
        lines.append(f"declare double @rotation_{name}({', '.join(['double'] * n)})")
    for kind, word in ((f"<{WIDTH} x double>", "f64"), (f"<{WIDTH} x float>", "f32")):
        for name, n in (("fabs", 1), ("sqrt", 1), ("fma", 3)):
            lines.append(f"declare {kind} @llvm.{name}.v{WIDTH}{word}({', '.join([kind] * n)})")
    return lines


def _stretch(fast: Fast, operands: tuple[Operand, ...], results: int, number: str) -> str:
    """Write the fast loop from row ``first`` on: it returns the row where one is not right, else ``end``."""
    program = Program(number, fused=True)
    arguments = "".join(f", ptr %p{n}, i64 %c{n}" for n in range(len(operands)))
    lines = program.lines
    columns = [_columns(program, n, operand) for n, operand in enumerate(operands)]
    lines.append("br label %head")
    program.begin("head")
    lines += [
        "%i = phi i64 [ %first, %start ], [ %next, %write ]",
        "%more = icmp slt i64 %i, %end",
        "br i1 %more, label %body, label %out",
    ]
    program.begin("body")
    read = operands[: len(operands) - results]
    rows = [_read(program, o, c) for o, c in zip(read, columns, strict=False)]
    image, right = fast(*rows)
    if right is None:
        lines.append("br label %write")
    else:
        wrong = program.some((~right).name)
        lines.append(f"br i1 {wrong}, label %out, label %write")
    program.begin("write")
    if results:
        _write(program, operands[-1], columns[-1], image)
    lines += [f"%next = add i64 %i, {WIDTH}", "br label %head"]
    program.begin("out")
    head = f"define internal i64 @stretch(i64 %first, i64 %end{arguments}) noinline {{"
    return "\n".join([head, "start:", *lines, "ret i64 %i", "}"])


def _eight(
    fast: Fast,
    careful: Careful | None,
    operands: tuple[Operand, ...],
    results: int,
    number: str,
) -> str:
    """Write the function that does eight rows in columns of eight, whatever they hold, and may tell."""
    program = Program(number, fused=True)
    columns = []
    for n, operand in enumerate(operands):
        own = [program.value("ptr", f"getelementptr i8, ptr %p{n}, i64 {k * WIDTH * operand.size}")
               for k in range(operand.width)]  # fmt: skip
        columns.append(own)
    near = [operand._replace(way=Way.COLUMNS) for operand in operands]
    read = near[: len(near) - results]
    rows = [_read(program, o, c, "0") for o, c in zip(read, columns, strict=False)]
    image, right = fast(*rows)
    if right is not None and careful is not None:

        def mended() -> tuple[Lanes, ...]:
            program.flags = ""
            done = careful(*rows)
            return tuple(tracing.where(right, a, b) for a, b in zip(image, done, strict=True))

        image = tracing.rarely(~right, mended, image)
    if results:
        _write(program, near[-1], columns[-1], image, "0")
    told = "false"
    for condition in program.told:
        told = program.value("i1", f"or i1 {told}, {program.some(condition)}")
    arguments = ", ".join(f"ptr %p{n}" for n in range(len(operands)))
    head = f"define internal i1 @eight({arguments}) {{"
    return "\n".join([head, "start:", *program.lines, f"ret i1 {told}", "}"])


def _few(operands: tuple[Operand, ...], results: int) -> str:
    """Write the function that does up to eight rows of whatever kind through a buffer.

    The last one is repeated to fill up, so that each row is computed as in any other place.
    """
    places = range(len(operands))
    arguments = "".join(f", ptr %p{n}, i64 %c{n}" for n in places)
    lines = ["%last = sub i64 %m, 1"]
    for n, o in enumerate(operands):
        step = _step(o)
        lines += [
            f"%b{n} = alloca [{WIDTH * o.width * o.size} x i8], align 64",
            f"%o{n} = mul i64 %first, {step}",
            f"%f{n} = getelementptr i8, ptr %p{n}, i64 %o{n}",
        ]
        if n < len(operands) - results:
            column = f"i64 {WIDTH * o.size}, i64 {o.size}"
            lines.append(copy_call(o, f"%b{n}, {column}", f"%f{n}, i64 %c{n}, i64 {step}", WIDTH))
    lines.append(f"%told = call i1 @eight({', '.join(f'ptr %b{n}' for n in places)})")
    if results:
        o, n = operands[-1], len(operands) - 1
        column = f"i64 {WIDTH * o.size}, i64 {o.size}"
        lines.append(copy_call(o, f"%f{n}, i64 %c{n}, i64 {_step(o)}", f"%b{n}, {column}", "%m"))
    head = f"define internal i1 @few(i64 %first, i64 %m{arguments}) noinline {{"
    return "\n".join([head, "start:", *lines, "ret i1 %told", "}"])


def _step(operand: Operand) -> int:
    """Return the bytes from one row to the next, in memory or in the columns that a block is copied to."""
    if operand.way is Way.SAME:
        return 0
    return operand.size * (operand.width if operand.way is Way.SIDE_BY_SIDE else 1)


def _entry(operands: tuple[Operand, ...], results: int) -> str:
    count = len(operands)
    first, walk, last = list[str](), list[str](), list[str]()
    for n, o in enumerate(operands):
        for k, name in enumerate(("a", "s", "q", "t")):
            first += [
                f"%at_{name}{n} = getelementptr i64, ptr %table, i64 {2 + 4 * n + k}",
                f"%{name}{n} = load i64, ptr %at_{name}{n}",
            ]
        walk += [
            f"%x{n} = mul i64 %o, %q{n}",
            f"%y{n} = mul i64 %row, %t{n}",
            f"%z{n} = add i64 %x{n}, %y{n}",
            f"%w{n} = add i64 %a{n}, %z{n}",
        ]
        written = n >= count - results
        if o.way is not Way.STRIDED:
            walk += [f"%p{n} = inttoptr i64 %w{n} to ptr", f"%c{n} = add i64 %s{n}, 0"]
            continue
        column = BLOCK * o.size
        first.append(f"%p{n} = alloca [{column * o.width} x i8], align 64")
        walk += [f"%there{n} = inttoptr i64 %w{n} to ptr", f"%c{n} = add i64 {column}, 0"]
        here, there = f"%p{n}, i64 {column}, i64 {o.size}", f"%there{n}, i64 %s{n}, i64 %t{n}"
        if written:
            last.append(copy_call(o, there, here, "%m"))
        else:
            walk.append(copy_call(o, here, there, "%m"))
    return (
        _WALK.replace("FIRST", "\n".join(first))
        .replace("PLACES", "\n".join(walk))
        .replace("LAST", "\n".join(last))
        .replace("OPERANDS", "".join(f", ptr %p{n}, i64 %c{n}" for n in range(count)))
        .replace("BLOCK", str(BLOCK))
        .replace("TAKE", str(TAKE))
        .replace("WIDTH", str(WIDTH))
    )


_WALK = """
define i64 @entry(ptr %counter, ptr %table) {
start:
  %outer = load i64, ptr %table
  %inner_at = getelementptr i64, ptr %table, i64 1
  %inner = load i64, ptr %inner_at
  %padded = add i64 %inner, sub (i64 BLOCK, i64 1)
  %each = sdiv i64 %padded, BLOCK
  %total = mul i64 %outer, %each
FIRST
  br label %turn
turn:
  %told = phi i1 [ false, %start ], [ %told_here, %test ]
  %begin = atomicrmw add ptr %counter, i64 TAKE monotonic
  %none = icmp sge i64 %begin, %total
  br i1 %none, label %over, label %some
some:
  %beyond = add i64 %begin, TAKE
  %fits = icmp slt i64 %beyond, %total
  %end = select i1 %fits, i64 %beyond, i64 %total
  br label %test
test:
  %block = phi i64 [ %begin, %some ], [ %block_next, %done ]
  %told_here = phi i1 [ %told, %some ], [ %told_all, %done ]
  %left = icmp slt i64 %block, %end
  br i1 %left, label %work, label %turn
work:
  %o = sdiv i64 %block, %each
  %of = srem i64 %block, %each
  %row = mul i64 %of, BLOCK
  %rest = sub i64 %inner, %row
  %short = icmp slt i64 %rest, BLOCK
  %m = select i1 %short, i64 %rest, i64 BLOCK
PLACES
  %whole = and i64 %m, -WIDTH
  br label %go
go:
  %from = phi i64 [ 0, %work ], [ %after, %mend ]
  %told_so = phi i1 [ %told_here, %work ], [ %told_more, %mend ]
  %i = call i64 @stretch(i64 %from, i64 %whole OPERANDS)
  %stopped = icmp slt i64 %i, %whole
  br i1 %stopped, label %mend, label %tail
mend:
  %told_now = call i1 @few(i64 %i, i64 WIDTH OPERANDS)
  %told_more = or i1 %told_so, %told_now
  %after = add i64 %i, WIDTH
  br label %go
tail:
  %odd = sub i64 %m, %whole
  %even = icmp eq i64 %odd, 0
  br i1 %even, label %done, label %finish
finish:
  %told_last = call i1 @few(i64 %whole, i64 %odd OPERANDS)
  br label %done
done:
  %told_tail = phi i1 [ false, %tail ], [ %told_last, %finish ]
  %told_all = or i1 %told_so, %told_tail
LAST
  %block_next = add i64 %block, 1
  br label %test
over:
  %answer = zext i1 %told to i64
  ret i64 %answer
}
"""


def _columns(program: Program, n: int, operand: Operand) -> list[str]:
    """Add what the loop needs of an operand before it begins: its columns, or its one row spread out."""
    if operand.way is Way.SIDE_BY_SIDE:
        return [f"%p{n}"]
    found = []
    for k in range(operand.width):
        offset = program.value("i64", f"mul i64 %c{n}, {k}")
        found.append(program.value("ptr", f"getelementptr i8, ptr %p{n}, i64 {offset}"))
    if operand.way is not Way.SAME:
        return found
    kind = f"<{WIDTH} x {operand.number}>"
    spread = []
    for place in found:
        one = program.value("", f"load {operand.number}, ptr {place}, align {operand.size}")
        first = program.value("", f"insertelement {kind} poison, {operand.number} {one}, i32 0")
        spread.append(
            program.value(
                "",
                f"shufflevector {kind} {first}, {kind} poison, <{WIDTH} x i32> zeroinitializer",
            )
        )
    return spread


def _read(program: Program, operand: Operand, columns: list[str], i: str = "%i") -> Rows:
    """Add the reading of eight rows from row ``i`` on."""
    kind = f"<{WIDTH} x {operand.number}>"
    if operand.way is Way.SAME:
        numbers = columns
    elif operand.way is Way.SIDE_BY_SIDE:
        numbers = _parted(program, operand, columns[0], i)
    else:
        if i != "0":
            _ahead(program, operand, columns, AHEAD, 0)
        numbers = []
        for column in columns:
            here = program.value("", f"getelementptr {operand.number}, ptr {column}, i64 {i}")
            numbers.append(program.value("", f"load {kind}, ptr {here}, align {operand.size}"))
    lanes = [
        Lanes(program, _converted(program, x, operand.number, program.number)) for x in numbers
    ]
    return Rows((operand.width,), lanes)


def _ahead(program: Program, operand: Operand, columns: list[str], rows: int, writing: int) -> None:
    """Ask for the memory of eight rows to come; it need not be ours."""
    step = operand.size if operand.way is not Way.SIDE_BY_SIDE else operand.width * operand.size
    row = program.value("i64", f"add i64 %i, {rows}")
    first = program.value("i64", f"mul i64 {row}, {step}")
    for column in columns:
        for line in range(0, WIDTH * step, LINE):
            offset = program.value("i64", f"add i64 {first}, {line}")
            place = program.value("ptr", f"getelementptr i8, ptr {column}, i64 {offset}")
            program.lines.append(
                f"call void @llvm.prefetch.p0(ptr {place}, i32 {writing}, i32 3, i32 1)"
            )


def _parted(program: Program, operand: Operand, base: str, i: str) -> list[str]:
    """Add the reading of rows whose components lie side by side, and their parting into columns."""
    n, number = operand.width, operand.number
    kind = f"<{WIDTH} x {number}>"
    parts = []
    first = program.value("i64", f"mul i64 {i}, {n}")
    start = program.value("ptr", f"getelementptr {number}, ptr {base}, i64 {first}")
    for k in range(n):
        place = program.value("ptr", f"getelementptr {kind}, ptr {start}, i64 {k}")
        parts.append(program.value("", f"load {kind}, ptr {place}, align {operand.size}"))
    return [_column(program, kind, parts, k) for k in range(n)]


def _column(program: Program, kind: str, parts: list[str], k: int) -> str:
    """Return every n-th number of n vectors, from number k on, gathered part after part."""
    n = len(parts)
    column, found = parts[0], list(range(k, WIDTH, n))
    for number, part in enumerate(parts[1:], 1):
        more = range((k - number * WIDTH) % n, WIDTH, n)
        places = [*found, *(WIDTH + place for place in more)]
        mask = ", ".join(f"i32 {p}" for p in places + [0] * (WIDTH - len(places)))
        text = f"shufflevector {kind} {column}, {kind} {part}, <{WIDTH} x i32> <{mask}>"
        column, found = program.value(kind, text), list(range(len(places)))
    return column


def _write(
    program: Program, operand: Operand, columns: list[str], image: tuple[Lanes, ...], i: str = "%i"
) -> None:
    """Add the writing of three coordinates of eight rows."""
    number = operand.number
    numbers = [_converted(program, x.name, program.number, number) for x in image]
    kind = f"<{WIDTH} x {number}>"
    if i != "0":
        _ahead(program, operand, columns, WRITTEN_AHEAD, 1)
    if operand.way is not Way.SIDE_BY_SIDE:
        for x, column in zip(numbers, columns, strict=True):
            here = program.value("", f"getelementptr {number}, ptr {column}, i64 {i}")
            program.lines.append(f"store {kind} {x}, ptr {here}, align {operand.size}")
        return
    x, y, z = numbers
    pair = f"<{2 * WIDTH} x {number}>"
    both = ", ".join(f"i32 {n}" for n in range(2 * WIDTH))
    first = program.value(
        pair, f"shufflevector {kind} {x}, {kind} {y}, <{2 * WIDTH} x i32> <{both}>"
    )
    rest = program.value(
        pair, f"shufflevector {kind} {z}, {kind} {z}, <{2 * WIDTH} x i32> <{both}>"
    )
    order = ", ".join(f"i32 {c * WIDTH + row}" for row in range(WIDTH) for c in range(3))
    count = 3 * WIDTH
    rows = program.value(
        "", f"shufflevector {pair} {first}, {pair} {rest}, <{count} x i32> <{order}>"
    )
    start = program.value("i64", f"mul i64 {i}, 3")
    here = program.value("ptr", f"getelementptr {number}, ptr {columns[0]}, i64 {start}")
    program.lines.append(f"store <{count} x {number}> {rows}, ptr {here}, align {operand.size}")


def _converted(program: Program, name: str, number: str, wanted: str) -> str:
    """Add the conversion of eight numbers to another precision, where it is another."""
    if number == wanted:
        return name
    how = "fpext" if wanted == "double" else "fptrunc"
    return program.value("", f"{how} <{WIDTH} x {number}> {name} to <{WIDTH} x {wanted}>")
