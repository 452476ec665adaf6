"""Compile formulas to machine code, and run it on several threads.

`instructions` writes programs in LLVM's notation; `machine_code` compiles them in milliseconds and caches
them on this machine (`disk_cache`). `loops` wraps a straight-line program in an `arithmetic` (those of rings
are in `arithmetics`) in a loop over the rows of arrays, and `calling` runs it in `threads`. LLVM comes with
numba, but numba itself, which takes a second to import, is not needed.
"""
