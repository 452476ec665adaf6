"""How an operand lies in memory, and the reading and writing of eight of its rows, in LLVM's notation."""

from enum import Enum
from typing import NamedTuple

from rotation.native.symbols import WIDTH, Lanes, Program, Rows

LINE = 64  # bytes that a processor fetches at once
AHEAD = 8 * WIDTH  # rows; so many columns at once are more than a processor foresees
WRITTEN_AHEAD = 4 * WIDTH  # rows; memory asked for to be written is not fetched twice


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

    @property
    def step(self) -> int:
        """The bytes from one row to the next, in memory or in the columns that a block is copied to."""
        if self.way is Way.SAME:
            return 0
        return self.size * (self.width if self.way is Way.SIDE_BY_SIDE else 1)


def columns_of(program: Program, n: int, operand: Operand) -> list[str]:
    """Add what the loop needs of an operand before it begins: its columns, or its one row spread out."""
    if operand.way is Way.SIDE_BY_SIDE:
        return [f"%p{n}"]
    found = []
    for k in range(operand.width):
        offset = program.value(f"mul i64 %c{n}, {k}")
        found.append(program.value(f"getelementptr i8, ptr %p{n}, i64 {offset}"))
    if operand.way is not Way.SAME:
        return found
    return [program.spread(place, operand.number, operand.size) for place in found]


def read(program: Program, operand: Operand, columns: list[str], i: str = "%i") -> Rows:
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
            here = program.value(f"getelementptr {operand.number}, ptr {column}, i64 {i}")
            numbers.append(program.value(f"load {kind}, ptr {here}, align {operand.size}"))
    lanes = [
        Lanes(program, _converted(program, x, operand.number, program.number)) for x in numbers
    ]
    return Rows((operand.width,), lanes)


def _ahead(program: Program, operand: Operand, columns: list[str], rows: int, writing: int) -> None:
    """Ask for the memory of eight rows to come; it need not be ours."""
    step = operand.step
    row = program.value(f"add i64 %i, {rows}")
    first = program.value(f"mul i64 {row}, {step}")
    for column in columns:
        for line in range(0, WIDTH * step, LINE):
            offset = program.value(f"add i64 {first}, {line}")
            place = program.value(f"getelementptr i8, ptr {column}, i64 {offset}")
            program.lines.append(
                f"call void @llvm.prefetch.p0(ptr {place}, i32 {writing}, i32 3, i32 1)"
            )


def _parted(program: Program, operand: Operand, base: str, i: str) -> list[str]:
    """Add the reading of rows whose components lie side by side, and their parting into columns."""
    n, number = operand.width, operand.number
    kind = f"<{WIDTH} x {number}>"
    parts = []
    first = program.value(f"mul i64 {i}, {n}")
    start = program.value(f"getelementptr {number}, ptr {base}, i64 {first}")
    for k in range(n):
        place = program.value(f"getelementptr {kind}, ptr {start}, i64 {k}")
        parts.append(program.value(f"load {kind}, ptr {place}, align {operand.size}"))
    return [_column(program, kind, parts, k) for k in range(n)]


def _column(program: Program, kind: str, parts: list[str], k: int) -> str:
    """Return every n-th number of n vectors, from number k on, gathered part after part."""
    n = len(parts)
    column, found = parts[0], list(range(k, WIDTH, n))
    for number, part in enumerate(parts[1:], 1):
        more = range((k - number * WIDTH) % n, WIDTH, n)
        places = [*found, *(WIDTH + place for place in more)]
        filled = places + [0] * (WIDTH - len(places))
        column, found = program.shuffled(kind, column, part, filled), list(range(len(places)))
    return column


def write(
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
            here = program.value(f"getelementptr {number}, ptr {column}, i64 {i}")
            program.lines.append(f"store {kind} {x}, ptr {here}, align {operand.size}")
        return
    x, y, z = numbers
    pair = f"<{2 * WIDTH} x {number}>"
    first = program.shuffled(kind, x, y, range(2 * WIDTH))
    rest = program.shuffled(kind, z, z, range(2 * WIDTH))
    order = [c * WIDTH + row for row in range(WIDTH) for c in range(3)]
    rows = program.shuffled(pair, first, rest, order)
    start = program.value(f"mul i64 {i}, 3")
    here = program.value(f"getelementptr {number}, ptr {columns[0]}, i64 {start}")
    program.lines.append(
        f"store <{len(order)} x {number}> {rows}, ptr {here}, align {operand.size}"
    )


def _converted(program: Program, name: str, number: str, wanted: str) -> str:
    """Add the conversion of eight numbers to another precision, where it is another."""
    if number == wanted:
        return name
    how = "fpext" if wanted == "double" else "fptrunc"
    return program.value(f"{how} <{WIDTH} x {number}> {name} to <{WIDTH} x {wanted}>")
