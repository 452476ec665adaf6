"""A moving WebP."""

from anim.errors import AnimationError
from anim.output.encoder import Encoded
from anim.output.format import Film

LARGEST_SIDE = 16_383


class WebP(Encoded):
    """Animated WebP: lossy, repeated forever."""

    counts_frames = False

    def check(self, film: Film) -> None:
        """Raise :class:`AnimationError` for pictures that are too wide or too high."""
        if max(film.size) > LARGEST_SIDE:
            raise AnimationError(f"webp is at most {LARGEST_SIDE} pixels wide and high")
        super().check(film)

    def options(self, film: Film) -> list[str]:
        """Return libwebp's options; quality 100 is the best, and about 85 corresponds to mp4 with crf 18."""
        quality = str(round(100 - 0.8 * film.crf))
        return ["-c:v", "libwebp_anim", "-quality", quality, "-loop", "0", "-f", "webp"]


FORMAT = WebP()
