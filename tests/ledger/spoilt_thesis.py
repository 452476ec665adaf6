"""The thesis's functions with one line changed, and the claims that are proved by running them."""

import importlib
import inspect
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager

from hfield.ledger.claim import Claim
from rotation import thesis


@contextmanager
def spoilt_thesis(
    line: str, mutant: str, package: str, modules: Sequence[str]
) -> Iterator[tuple[Claim, ...]]:
    """Yield a package's claims as its ``modules`` read the functions then; afterwards all is as before."""

    def reread() -> None:
        for module in modules:
            importlib.reload(sys.modules[f"{package}.{module}"])
        importlib.reload(sys.modules[package])

    source = inspect.getsource(thesis)
    assert source.count(line) == 1
    try:
        exec(compile(source.replace(line, mutant), thesis.__name__, "exec"), vars(thesis))
        reread()
        yield sys.modules[package].CLAIMS
    finally:
        importlib.reload(thesis)
        reread()
