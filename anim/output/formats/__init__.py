"""The formats of films, one module each, named after the suffix, with an object ``FORMAT``."""

from __future__ import annotations

from typing import TYPE_CHECKING

from anim.catalogue import Catalogue

if TYPE_CHECKING:
    from anim.output.format import Format

FORMATS: Catalogue[Format] = Catalogue(__name__, "FORMAT")
