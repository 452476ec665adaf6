"""Formulas as machine code: a formula written for arrays is traced once and compiled in milliseconds.

`tracing` runs a formula on symbols and writes down what it does; `assembling` makes a function of that;
`calling` gives it arrays. LLVM comes with numba, but numba itself is not imported.
"""
