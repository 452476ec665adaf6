"""Formulas as machine code: a formula written for arrays is traced once and compiled in milliseconds.

`tracing` runs a formula on `symbols`, which write down what is done to them. `looping` puts that into a loop,
and `assembling` makes a function of it, compiled by `hfield.compiling`. `sweeping` is the walk over many points
whose `operands` lie in memory anyhow.
"""
