"""Compile formulas to machine code, and run it on several threads.

`instructions` writes programs in LLVM's notation; `machine_code` compiles them in milliseconds, once on
this machine (`disk_cache`), for as long as the process lives. `loops` puts a straight-line program in an
`arithmetic` (those of rings are `arithmetics`) into a loop over the rows of arrays, and `calling` runs it in
`threads`. LLVM comes with numba, but numba itself, which takes a second to import, is not needed.
"""
