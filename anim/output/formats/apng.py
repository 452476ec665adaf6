"""Lossless animated PNG."""

from anim.output.encoder import Encoded
from anim.output.format import Film


class Apng(Encoded):
    """Animated PNG: lossless."""

    def options(self, film: Film) -> list[str]:
        """Return ffmpeg's options; the animation repeats forever."""
        return ["-f", "apng", "-pred", "mixed", "-plays", "0"]


FORMAT = Apng()
