"""Importing matplotlib without its log: where it keeps settings and fonts is no reader's business."""

import logging


def import_matplotlib() -> None:
    """Import matplotlib and its fonts; the list of fonts is built at the first use on a machine.

    With a home that cannot be written it takes a temporary folder, and tells processes started later
    of it, by the environment.
    """
    logger = logging.getLogger("matplotlib")
    level = logger.level
    logger.setLevel(logging.ERROR)
    try:
        import matplotlib.font_manager  # noqa: F401
    finally:
        logger.setLevel(level)
