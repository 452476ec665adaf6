"""A moving WebP."""

from anim.errors import AnimationError
from anim.output.encoder import Encoded
from anim.output.format import Film

LARGEST_SIDE = 16_383


class WebP(Encoded):
    """Lossy pictures, which play for ever."""

    counts_frames = False

    def check(self, film: Film) -> None:
        """Refuse pictures that are too wide or high."""
        if max(film.size) > LARGEST_SIDE:
            raise AnimationError(f"webp is at most {LARGEST_SIDE} pixels wide and high")
        super().check(film)

    def options(self, film: Film) -> list[str]:
        """Return libwebp's options."""
        return ["-c:v", "libwebp_anim", "-quality", "85", "-loop", "0", "-f", "webp"]


FORMAT = WebP()
