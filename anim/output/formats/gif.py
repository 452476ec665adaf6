"""Animated GIF with 256 colours."""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from anim.errors import AnimationError
from anim.output.encoder import Encoded
from anim.output.format import Film, Samples, Write
from anim.output.palette import write_palette

FASTEST_FPS = 50.0  # browsers slow down pictures shown for less than two hundredths of a second
DITHERED = "[0][1]paletteuse=dither=bayer:bayer_scale=5:diff_mode=rectangle"


class Gif(Encoded):
    """A GIF with a single palette, computed from frames of the whole film."""

    def check(self, film: Film) -> None:
        """Raise :class:`AnimationError` for a frame rate that browsers do not support."""
        if film.fps > FASTEST_FPS:
            raise AnimationError(
                f"a gif shows at most {FASTEST_FPS:g} frames a second, not {film.fps:g}; "
                "lower --fps, or choose .webp, .apng or .mp4"
            )
        super().check(film)

    def options(self, film: Film) -> list[str]:
        """Return ffmpeg's options for frames and a palette."""
        return ["-lavfi", DITHERED, "-f", "gif"]

    @contextmanager
    def open(self, path: Path, film: Film, samples: Samples | None) -> Iterator[Write]:
        """Yield a function that sends a frame to ffmpeg, which reads the palette from a picture."""
        palette = path.with_suffix(".palette.png")
        try:
            write_palette(palette, samples() if samples else ())
            picture = ("-f", "image2", "-pattern_type", "none", "-i", str(palette))
            with self.encoder(path, film, picture) as write:
                yield write
        finally:
            palette.unlink(missing_ok=True)


FORMAT = Gif()
