"""Formulas as machine code: a formula written for arrays is traced once and compiled in milliseconds.

`tracing` runs a formula on symbols and writes down what it does, `looping` puts that into a loop, and
`assembling` makes a function of it, compiled by `hfield.native`.
"""
