"""The loop around a formula, in LLVM's notation: from headers of numpy's arrays to blocks of eight rows."""

from rotation.native.symbols import WIDTH

FREE = 2048  # rows for which it pays to free the interpreter lock
_HEAD = object.__basicsize__
DATA, NDIM, LENGTHS, FLAGS = (
    _HEAD,
    _HEAD + 8,
    _HEAD + 16,
    _HEAD + 48,
)  # where numpy's header has them
USABLE = 0x0001 | 0x0100  # C order, aligned

FRAME = (
    """
declare ptr @PyLong_FromLong(i64)
declare ptr @PyEval_SaveThread()
declare void @PyEval_RestoreThread(ptr)
declare void @llvm.memcpy.p0.p0.i64(ptr, ptr, i64, i1)

define internal i64 @elements(ptr %array) {
start:
  %n_at = getelementptr i8, ptr %array, i64 NDIM
  %n32 = load i32, ptr %n_at
  %n = sext i32 %n32 to i64
  %d_at = getelementptr i8, ptr %array, i64 LENGTHS
  %d = load ptr, ptr %d_at
  br label %test
test:
  %i = phi i64 [ 0, %start ], [ %next, %more ]
  %size = phi i64 [ 1, %start ], [ %larger, %more ]
  %done = icmp sge i64 %i, %n
  br i1 %done, label %end, label %more
more:
  %at = getelementptr i64, ptr %d, i64 %i
  %length = load i64, ptr %at
  %larger = mul i64 %size, %length
  %next = add i64 %i, 1
  br label %test
end:
  ret i64 %size
}

define internal i1 @usable(ptr %array) {
  %at = getelementptr i8, ptr %array, i64 FLAGS
  %flags = load i32, ptr %at
  %bits = and i32 %flags, USABLE
  %yes = icmp eq i32 %bits, USABLE
  ret i1 %yes
}
""".replace("NDIM", str(NDIM))
    .replace("LENGTHS", str(LENGTHS))
    .replace("FLAGS", str(FLAGS))
    .replace("USABLE", str(USABLE))
)


def loop(sizes: list[int], width: int, single: tuple[int, ...] = ()) -> str:
    """Write the builtin: it reads the arrays' headers and runs through blocks of eight rows.

    The rows left over at the end go through a buffer, as does the one row of an array that is the same
    for all, but of those that always have one row: the block itself spreads them.
    """
    lines = ["define ptr @entry(ptr %self, ptr %args, i64 %nargs) {", "start:"]
    count = len(sizes)
    moving = [(n, size) for n, size in enumerate(sizes) if n not in single]
    for n, size in enumerate([*sizes, width]):
        lines += [
            f"%arg{n} = getelementptr ptr, ptr %args, i64 {n}",
            f"%array{n} = load ptr, ptr %arg{n}",
            f"%data_at{n} = getelementptr i8, ptr %array{n}, i64 {DATA}",
            f"%data{n} = load ptr, ptr %data_at{n}",
            f"%size{n} = call i64 @elements(ptr %array{n})",
            f"%rows{n} = sdiv i64 %size{n}, {size}",
            f"%buffer{n} = alloca <{size * WIDTH} x double>, align 64",
            f"%usable{n} = call i1 @usable(ptr %array{n})",
        ]
    rows = f"%rows{count}"
    good = f"%usable{count}"
    for n in range(count):
        lines += [
            f"%same{n} = icmp eq i64 %rows{n}, {rows}",
            f"%one{n} = icmp eq i64 %rows{n}, 1",
            f"%fits{n} = or i1 {'false' if n in single else f'%same{n}'}, %one{n}",
            f"%both{n} = and i1 %fits{n}, %usable{n}",
            f"%good{n} = and i1 {good}, %both{n}",
            f"%fixed{n} = xor i1 %same{n}, true",
        ]
        good = f"%good{n}"
    lines += [f"br i1 {good}, label %begin, label %refuse", "refuse:"]
    lines += ["%no = call ptr @PyLong_FromLong(i64 1)", "ret ptr %no", "begin:"]
    previous = "begin"
    for n, size in moving:
        lines += [f"br i1 %fixed{n}, label %spread{n}, label %next{n}", f"spread{n}:"]
        for row in range(WIDTH):
            lines += [
                f"%to{n}_{row} = getelementptr double, ptr %buffer{n}, i64 {row * size}",
                f"call void @llvm.memcpy.p0.p0.i64(ptr %to{n}_{row}, ptr %data{n}, i64 {size * 8}, i1 false)",
            ]
        lines += [f"br label %next{n}", f"next{n}:"]
        previous = f"next{n}"
    lines += [
        f"%long = icmp sge i64 {rows}, {FREE}",
        "br i1 %long, label %free, label %held",
        "free:",
        "%saved = call ptr @PyEval_SaveThread()",
        "br label %held",
        "held:",
        f"%state = phi ptr [ %saved, %free ], [ null, %{previous} ]",
        "br label %test",
        "test:",
        "%i = phi i64 [ 0, %held ], [ %i_next, %written ]",
        "%said = phi i1 [ false, %held ], [ %says_more, %written ]",
        f"%left = sub i64 {rows}, %i",
        "%more = icmp sgt i64 %left, 0",
        "br i1 %more, label %body, label %over",
        "body:",
        f"%full = icmp sge i64 %left, {WIDTH}",
        "br i1 %full, label %run, label %partly",
        "partly:",
    ]
    for n, size in moving:
        lines += [
            f"br i1 %fixed{n}, label %filled{n}, label %fill{n}",
            f"fill{n}:",
            f"%start{n} = mul i64 %i, {size}",
            f"%from{n} = getelementptr double, ptr %data{n}, i64 %start{n}",
            f"%bytes{n} = mul i64 %left, {size * 8}",
        ]
        for row in range(1, WIDTH):  # so that no row of the buffer is what nobody wrote
            lines += [
                f"%pad{n}_{row} = getelementptr double, ptr %buffer{n}, i64 {row * size}",
                f"call void @llvm.memcpy.p0.p0.i64(ptr %pad{n}_{row}, ptr %from{n}, "
                f"i64 {size * 8}, i1 false)",
            ]
        lines += [
            f"call void @llvm.memcpy.p0.p0.i64(ptr %buffer{n}, ptr %from{n}, i64 %bytes{n}, i1 false)",
            f"br label %filled{n}",
            f"filled{n}:",
        ]
    lines += ["br label %run", "run:"]
    for n, size in moving:
        lines += [
            f"%offset{n} = mul i64 %i, {size}",
            f"%here{n} = getelementptr double, ptr %data{n}, i64 %offset{n}",
            f"%moving{n} = select i1 %full, ptr %here{n}, ptr %buffer{n}",
            f"%source{n} = select i1 %fixed{n}, ptr %buffer{n}, ptr %moving{n}",
        ]
    sources = ", ".join(f"ptr %{'data' if n in single else 'source'}{n}" for n in range(count))
    lines += [
        f"%offset = mul i64 %i, {width}",
        f"%there = getelementptr double, ptr %data{count}, i64 %offset",
        f"%target = select i1 %full, ptr %there, ptr %buffer{count}",
        f"%says = call i1 @block({sources}, ptr %target)",
        "%says_more = or i1 %said, %says",
        "br i1 %full, label %written, label %copy",
        "copy:",
        f"%bytes = mul i64 %left, {width * 8}",
        f"call void @llvm.memcpy.p0.p0.i64(ptr %there, ptr %buffer{count}, i64 %bytes, i1 false)",
        "br label %written",
        "written:",
        f"%i_next = add i64 %i, {WIDTH}",
        "br label %test",
        "over:",
        "br i1 %long, label %take, label %answer",
        "take:",
        "call void @PyEval_RestoreThread(ptr %state)",
        "br label %answer",
        "answer:",
        "%status = select i1 %said, i64 2, i64 0",
        "%yes = call ptr @PyLong_FromLong(i64 %status)",
        "ret ptr %yes",
        "}",
    ]
    return "\n".join(lines)
