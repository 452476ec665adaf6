"""Machine code: programs in LLVM's notation, compiled in milliseconds and kept on disk; and threads to share.

LLVM comes with numba, but numba itself, which takes a second to import, is not needed.
"""
