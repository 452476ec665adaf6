"""Import matplotlib with its own settings instead of a user's."""

from __future__ import annotations

import logging
import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager

BACKEND = "MPLBACKEND"


def import_matplotlib() -> None:
    """Import matplotlib and its fonts; the list of fonts is built at the first use on a machine.

    With a home that cannot be written it takes a temporary folder, and tells processes started later
    of it, by the environment. A backend that MPLBACKEND names is left to those who open windows; one that
    matplotlib does not know is ignored.
    """
    logger = logging.getLogger("matplotlib")
    level = logger.level
    logger.setLevel(logging.ERROR)
    try:
        try:
            import matplotlib as _
        except ValueError:
            backend = os.environ.pop(BACKEND, None)
            if backend is None:
                raise
            try:
                for name in [name for name in sys.modules if name.split(".")[0] == "matplotlib"]:
                    del sys.modules[name]
                import matplotlib as _  # noqa: F401
            finally:
                os.environ[BACKEND] = backend
        import matplotlib.font_manager  # noqa: F401
    finally:
        logger.setLevel(level)


@contextmanager
def default_settings() -> Iterator[None]:
    """Draw with matplotlib's own settings, whatever a user's matplotlibrc says."""
    import_matplotlib()
    import matplotlib as mpl

    with mpl.rc_context():
        mpl.rcdefaults()
        yield
