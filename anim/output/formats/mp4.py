"""H.264, by x264."""

from collections.abc import Callable, Sequence

import numpy as np

from anim.errors import AnimationError
from anim.output.encoder import Encoded
from anim.output.format import Film, Pixels

# Tagged, so that players show the colours as drawn and ffmpeg converts nothing.
TAGS = [word for name in ("space", "_primaries", "_trc") for word in (f"-color{name}", "bt709")]
TAGS += ["-color_range", "tv"]

# The edges of the bands have strong colours and suffer most from coarse chroma. In small pictures
# four pixels are too many to share one chroma value; these keep full chroma (4:4:4).
FINER_CHROMA = -6
LARGE_PICTURE_PIXELS = 640 * 480


class Mp4(Encoded):
    """H.264 with the index at the front, so that it plays while it loads."""

    def check(self, film: Film) -> None:
        """Raise for an odd width or height."""
        width, height = film.size
        if width % 2 or height % 2:
            raise AnimationError(
                f"mp4 needs an even width and height, not {width}x{height}; "
                f"try --size {width + width % 2}x{height + height % 2}"
            )
        super().check(film)

    def raw(self, film: Film) -> tuple[Sequence[str], Callable[[Pixels], memoryview]]:
        """Return ffmpeg's options for luma and chroma, and the function that converts a frame to them.

        In large pictures the chroma of each block of 2 × 2 pixels is averaged."""
        from anim.output.luma import planes

        width, height = film.size
        block = 2 if width * height >= LARGE_PICTURE_PIXELS else 1
        whole = np.empty(width * height + 2 * (width // block) * (height // block), np.uint8)
        luma, rest = whole[: width * height].reshape(height, width), whole[width * height :]
        blue, red = rest.reshape(2, height // block, width // block)

        def encoded(frame: Pixels) -> memoryview:
            planes(np.ascontiguousarray(frame).reshape(height, -1), luma, blue, red)
            return whole.data

        return ("-pix_fmt", "yuv420p" if block == 2 else "yuv444p", *TAGS), encoded

    def options(self, film: Film) -> list[str]:
        """Return x264's options."""
        coded = ["-c:v", "libx264", "-crf", str(film.crf), "-preset", film.preset]
        coded += ["-x264-params", f"chroma-qp-offset={FINER_CHROMA}", *TAGS]
        return [*coded, "-movflags", "+faststart", "-f", "mp4"]


FORMAT = Mp4()
