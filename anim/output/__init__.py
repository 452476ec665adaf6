"""Films as files, by suffix: video, moving pictures, folders of pictures. Whole or not at all."""

from anim.output.formats import Film, check, open_film
from anim.output.sheet import sheet

__all__ = ["Film", "check", "open_film", "sheet"]
