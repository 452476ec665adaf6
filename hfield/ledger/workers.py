"""What the process reads that workers are forked from: how rows are decided, and all claims."""

from contextlib import suppress

from hfield.executors import collecting_rarely

with collecting_rarely():
    from hfield.ledger import run
    from hfield.ledger.registry import claims, find

    with suppress(Exception):  # of a ledger that cannot be read the command itself says so
        find(claims()[0].id)

__all__ = ["run"]
