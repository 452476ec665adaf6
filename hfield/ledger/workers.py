"""What the process reads that workers are forked from: how rows are decided, and all claims."""

import gc
from contextlib import suppress

from hfield.executors import collecting_rarely

with collecting_rarely():
    from hfield.ledger import run
    from hfield.ledger.registry import claims, find

    with suppress(Exception):  # of a ledger that cannot be read the command itself says so
        find(claims()[0].id)
gc.freeze()  # what is read is kept by all: no worker need look through it, nor copy its pages

__all__ = ["run"]
