"""The styles of drawing, one module each, with an object ``STYLE``."""

from __future__ import annotations

from typing import TYPE_CHECKING

from anim.catalogue import Catalogue

if TYPE_CHECKING:
    from anim.picture.style import Style

STYLES: Catalogue[Style] = Catalogue(__name__, "STYLE")
