"""The styles in which the top can be drawn, one module each, with a ``STYLE``."""

from __future__ import annotations

from typing import TYPE_CHECKING

from anim.catalogue import Catalogue

if TYPE_CHECKING:
    from anim.picture.style import Style

STYLES: Catalogue[Style] = Catalogue(__name__, "STYLE")
