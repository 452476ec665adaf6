"""Copies between strided rows and columns, in LLVM's notation."""

from rotation.native.operands import Operand

_COPY = """
define internal void @copySIZE(
  ptr %to, i64 %to_column, i64 %to_row, ptr %from, i64 %from_column, i64 %from_row,
  i64 %width, i64 %rows, i64 %last
) noinline {
start:
  br label %column
column:
  %k = phi i64 [ 0, %start ], [ %k_next, %after ]
  %more = icmp slt i64 %k, %width
  br i1 %more, label %begin, label %end
begin:
  %to_offset = mul i64 %k, %to_column
  %from_offset = mul i64 %k, %from_column
  %target = getelementptr i8, ptr %to, i64 %to_offset
  %source = getelementptr i8, ptr %from, i64 %from_offset
  br label %row
row:
  %j = phi i64 [ 0, %begin ], [ %j_next, %one ]
  %some = icmp slt i64 %j, %rows
  br i1 %some, label %one, label %after
one:
  %late = icmp sgt i64 %j, %last
  %found = select i1 %late, i64 %last, i64 %j
  %at_offset = mul i64 %found, %from_row
  %put_offset = mul i64 %j, %to_row
  %at = getelementptr i8, ptr %source, i64 %at_offset
  %put = getelementptr i8, ptr %target, i64 %put_offset
  %bits = load iBITS, ptr %at, align SIZE
  store iBITS %bits, ptr %put, align SIZE
  %j_next = add i64 %j, 1
  br label %row
after:
  %k_next = add i64 %k, 1
  br label %column
end:
  ret void
}
"""


def copy(size: int) -> str:
    """Write the function that copies columns of numbers of ``size`` bytes; strides are in bytes.

    Rows after ``last`` are copies of that one.
    """
    return _COPY.replace("BITS", str(8 * size)).replace("SIZE", str(size))


def copy_call(operand: Operand, to: str, source: str, rows: int | str) -> str:
    """Write a call that copies an operand's rows; the last of ``%m`` is repeated where there are more."""
    last = "%last" if isinstance(rows, int) else rows
    return (
        f"call void @copy{operand.size}(ptr {to}, ptr {source}, "
        f"i64 {operand.width}, i64 {rows}, i64 {last})"
    )
