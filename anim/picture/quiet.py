"""Importing matplotlib without a word: where it may keep settings and caches is no reader's business."""

import logging


def import_matplotlib() -> None:
    """Import matplotlib; with a home that cannot be written it takes a temporary folder, and says nothing.

    It tells processes started later of that folder, by the environment.
    """
    logger = logging.getLogger("matplotlib")
    level = logger.level
    logger.setLevel(logging.ERROR)
    try:
        import matplotlib  # noqa: F401
    finally:
        logger.setLevel(level)
