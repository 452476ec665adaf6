"""The walk of a formula over many points, in LLVM's notation: any strides, blocks that threads share.

A formula has two forms. ``fast(*rows)`` returns the new coordinates and where they are right, or None for
everywhere. ``careful(*rows)`` returns them for the rows where they are not. The fast loop is a function by
itself that calls nothing, so that what it needs stays in registers; eight rows in which one is not right
leave it and come back. Eight rows are read before they are written, so the result may be an operand.
"""

from collections.abc import Callable

from rotation.native import elementary_functions, tracing
from rotation.native.copying import copy, copy_call
from rotation.native.operands import Operand, Way, columns_of, read, write
from rotation.native.symbols import WIDTH, Condition, Lanes, Program

BLOCK = 512  # rows at a time; what is copied for a block stays in the nearest cache
TAKE = 16  # blocks a thread takes at a time

Fast = Callable[..., tuple[tuple[Lanes, ...], Condition | None]]
Careful = Callable[..., tuple[Lanes, ...]]


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
            "declare void @llvm.prefetch.p0(ptr, i32, i32, i32)",
            *elementary_functions.of_the_system(elementary_functions.LIBRARY),
            *elementary_functions.intrinsics("double", WIDTH),
            *elementary_functions.intrinsics("float", WIDTH),
            *(copy(size) for size in sizes),
            _stretch(fast, operands, results, number),
            _eight(fast, careful, operands, results, number),
            _few(operands, results),
            _entry(operands, results),
        ]
    )


def _stretch(fast: Fast, operands: tuple[Operand, ...], results: int, number: str) -> str:
    """Write the fast loop from row ``first`` on: it returns the row where one is not right, else ``end``."""
    program = Program(number, fused=True)
    arguments = "".join(f", ptr %p{n}, i64 %c{n}" for n in range(len(operands)))
    lines = program.lines
    columns = [columns_of(program, n, operand) for n, operand in enumerate(operands)]
    lines.append("br label %head")
    program.begin("head")
    lines += [
        "%i = phi i64 [ %first, %start ], [ %next, %write ]",
        "%more = icmp slt i64 %i, %end",
        "br i1 %more, label %body, label %out",
    ]
    program.begin("body")
    given = operands[: len(operands) - results]
    rows = [read(program, o, c) for o, c in zip(given, columns, strict=False)]
    image, right = fast(*rows)
    if right is None:
        lines.append("br label %write")
    else:
        wrong = program.some((~right).name)
        lines.append(f"br i1 {wrong}, label %out, label %write")
    program.begin("write")
    if results:
        write(program, operands[-1], columns[-1], image)
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
        own = [program.value(f"getelementptr i8, ptr %p{n}, i64 {k * WIDTH * operand.size}")
               for k in range(operand.width)]  # fmt: skip
        columns.append(own)
    near = [operand._replace(way=Way.COLUMNS) for operand in operands]
    given = near[: len(near) - results]
    rows = [read(program, o, c, "0") for o, c in zip(given, columns, strict=False)]
    image, right = fast(*rows)
    if right is not None and careful is not None:

        def mended() -> tuple[Lanes, ...]:
            program.flags = ""
            done = careful(*rows)
            return tuple(tracing.where(right, a, b) for a, b in zip(image, done, strict=True))

        image = tracing.rarely(~right, mended, image)
    if results:
        write(program, near[-1], columns[-1], image, "0")
    told = "false"
    for condition in program.told:
        told = program.value(f"or i1 {told}, {program.some(condition)}")
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
        step = o.step
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
        lines.append(copy_call(o, f"%f{n}, i64 %c{n}, i64 {o.step}", f"%b{n}, {column}", "%m"))
    head = f"define internal i1 @few(i64 %first, i64 %m{arguments}) noinline {{"
    return "\n".join([head, "start:", *lines, "ret i1 %told", "}"])


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
