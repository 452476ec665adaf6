"""H.264, by x264."""

from anim.errors import AnimationError
from anim.output.encoder import Encoded
from anim.output.format import Film

# Tagged and converted as BT.709, so that players show the colours that were drawn.
BT709 = ("-colorspace", "bt709", "-color_primaries", "bt709", "-color_trc", "bt709")
# Averaging chroma over each block of four keeps the most of what 4:2:0 can hold of sharp bands.
TO_BT709 = "scale=out_color_matrix=bt709:out_range=tv:flags=area+accurate_rnd+full_chroma_inp+full_chroma_int"

# The bands' edges are of strong colours, and lose more by coarse chroma than by anything else. In small
# pictures four pixels are too large for one chroma: they keep all of it (4:4:4).
FINER_CHROMA = -6
LARGE = 640 * 480


class Mp4(Encoded):
    """H.264, its index in front so that it plays while it loads."""

    def check(self, film: Film) -> None:
        """Refuse an odd width or height."""
        width, height = film.size
        if width % 2 or height % 2:
            raise AnimationError(
                f"mp4 needs an even width and height, not {width}x{height}; "
                f"try --size {width + width % 2}x{height + height % 2}"
            )
        super().check(film)

    def options(self, film: Film) -> list[str]:
        """Return x264's options, with coarse chroma where pixels are small."""
        coded = ["-c:v", "libx264", "-crf", str(film.crf), "-preset", film.preset]
        coded += ["-x264-params", f"chroma-qp-offset={FINER_CHROMA}", "-vf", TO_BT709, *BT709]
        chroma = "yuv420p" if film.size[0] * film.size[1] >= LARGE else "yuv444p"
        return [*coded, "-pix_fmt", chroma, "-movflags", "+faststart", "-f", "mp4"]


FORMAT = Mp4()
