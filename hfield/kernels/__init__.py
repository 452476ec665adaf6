"""Loops over arrays of quaternions: a straight-line program in the arithmetic of a ring, as machine code.

`arithmetic` says what an arithmetic is; `residues`, `binary_fields`, `extension_fields`, `logarithms`,
`register_tables` and `machine_integers` are such; `loops` puts a program into a loop, and `calling` runs it
over arrays.
"""
