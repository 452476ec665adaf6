"""Compile formulas to machine code: a formula for arrays is traced once and compiled in milliseconds.

`tracing` runs a formula on `symbols`, which record the operations on them. The recorded program is compiled
in one of two loops. `builtins` makes a builtin function of Python, which is fast even for one row.
`strided_loop` processes many points with any strides.
"""
