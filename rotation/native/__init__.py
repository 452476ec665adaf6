"""Formulas as machine code: a formula written for arrays is traced once and compiled in milliseconds.

`tracing` runs a formula on `symbols`, which write down what is done to them. Around that come two walks:
`builtins` makes a function of Python, quick for one row too; `sweeping` goes over many points lying anyhow.
"""
