"""Large results written past the caches: a processor need not read the lines that it is about to fill.

An ordinary store reads the line of 64 bytes it falls into first, so that a written byte travels twice. Here
the loop fills blocks that stay near the processor, and whole lines of them are copied out by stores that LLVM
calls non-temporal. That pays where memory is what one waits for, where the result fits no cache, and where
its pages are there already: a page that was just cleared lies in the cache, and would be written out twice.
"""

from collections.abc import Collection, Sequence

BLOCK = 512  # elements
COPY = """
define internal void @copy(ptr noalias %to, ptr noalias %from, i64 %bytes) noinline {
start:
%place = ptrtoint ptr %to to i64
%below = sub i64 0, %place
%gap = and i64 %below, 63
%first = call i64 @llvm.umin.i64(i64 %gap, i64 %bytes)
call void @llvm.memcpy.p0.p0.i64(ptr %to, ptr %from, i64 %first, i1 false)
%rest = sub i64 %bytes, %first
%whole = and i64 %rest, -64
%last = add i64 %first, %whole
%some = icmp ne i64 %whole, 0
br i1 %some, label %lines, label %end
lines:
%i = phi i64 [ %first, %start ], [ %next, %lines ]
%old = getelementptr i8, ptr %from, i64 %i
%new = getelementptr i8, ptr %to, i64 %i
%line = load <8 x i64>, ptr %old, align 1
store <8 x i64> %line, ptr %new, align 64, !nontemporal !2
%next = add i64 %i, 64
%more = icmp ult i64 %next, %last
br i1 %more, label %lines, label %end
end:
%tail = getelementptr i8, ptr %from, i64 %last
%there = getelementptr i8, ptr %to, i64 %last
%left = sub i64 %bytes, %last
call void @llvm.memcpy.p0.p0.i64(ptr %there, ptr %tail, i64 %left, i1 false)
ret void
}
declare i64 @llvm.umin.i64(i64, i64)
declare void @llvm.memcpy.p0.p0.i64(ptr, ptr, i64, i1)
!2 = !{i32 1}
"""


def entry(
    pointers: Sequence[str], moving: Collection[str], results: Sequence[str], read: str, kind: str
) -> str:
    """Write the function ``entry(n, addresses)`` that runs ``loop`` block by block and copies what it wrote.

    ``pointers`` are what the loop takes. Of these the ``moving`` have an element of the type ``read`` for
    each turn of the loop, and the ``results`` one of the type ``kind``; the others stay where they are.
    """
    lines = [COPY, "define i64 @entry(i64 %n, ptr %addresses) {", "start:"]
    for k, name in enumerate(pointers):
        lines.append(f"%at{k} = getelementptr ptr, ptr %addresses, i64 {k}")
        lines.append(f"%{name} = load ptr, ptr %at{k}")
    lines += [f"%near_{name} = alloca [{BLOCK} x {kind}], align 64" for name in results]
    lines += [
        "br label %block",
        "block:",
        "%done = phi i64 [ 0, %start ], [ %next, %block ]",
        "%told = phi i64 [ 0, %start ], [ %all, %block ]",
        "%left = sub i64 %n, %done",
        f"%length = call i64 @llvm.umin.i64(i64 %left, i64 {BLOCK})",
        *(f"%here_{name} = getelementptr {read}, ptr %{name}, i64 %done" for name in moving),
    ]
    prefix = dict.fromkeys(moving, "here_") | dict.fromkeys(results, "near_")
    passed = ", ".join(f"ptr %{prefix.get(name, '')}{name}" for name in pointers)
    lines += [
        f"%flags = call i64 @loop(i64 %length, {passed})",
        "%all = or i64 %told, %flags",
        f"%bytes = mul i64 %length, {int(kind[1:]) // 8}",
    ]
    for name in results:
        lines.append(f"%to_{name} = getelementptr {kind}, ptr %{name}, i64 %done")
        lines.append(f"call void @copy(ptr %to_{name}, ptr %near_{name}, i64 %bytes)")
    lines += [
        "%next = add i64 %done, %length",
        "%more = icmp ult i64 %next, %n",
        "br i1 %more, label %block, label %end",
        "end:",
        "fence seq_cst",  # another thread sees such stores after it only
        "ret i64 %all",
        "}",
    ]
    return "\n".join(lines)
