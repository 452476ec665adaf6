"""The whole of `hfield render`, process tree, against ffmpeg on the same frames; and its memory.

    python benchmarks/top_film.py [FRAMES]

Renders a warm-up film, then the default one (500 frames of 640 × 480 as mp4, crf 18, preset medium) three
times, with motion blur three times, and lets ffmpeg convert and encode the same raw frames from a file three
times.
Prints the CPU seconds, the least of three, and their ratios; and how long 1080p takes in two processes. Then
it renders 500 and FRAMES frames (default 3000) as mp4 and gif, and prints the largest memory of the process
tree (proportional set size, sampled). With FRAMES 0 the memory is left out.
"""

import os
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from anim.film import clip
from anim.model import Model
from anim.output.encoder import ffmpeg
from anim.output.format import Film
from anim.output.formats.mp4 import FORMAT
from anim.physics import physical
from anim.physics.films import STORY
from anim.picture.settings import FILM_SETTINGS
from anim.rendering import Scene, framed, frames

ROUNDS = 3
TO_BT709 = "scale=out_color_matrix=bt709:out_range=tv:flags=area+accurate_rnd+full_chroma_inp+full_chroma_int"


def cpu(words: list[str]) -> float:
    """Run a command to its end; return the CPU seconds of it and its children."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(words, check=True, stdout=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def tree(process: int) -> list[int]:
    """Return a process and all below it."""
    found = [process]
    try:
        for task in Path(f"/proc/{process}/task").iterdir():
            for child in (task / "children").read_text().split():
                found += tree(int(child))
    except OSError:
        pass
    return found


def memory(process: int) -> int:
    """Return the bytes that a process tree holds, shared pages divided among those who share them."""
    total = 0
    for number in tree(process):
        try:
            text = Path(f"/proc/{number}/smaps_rollup").read_text()
        except OSError:
            continue
        total += sum(int(line.split()[1]) for line in text.splitlines() if line.startswith("Pss:"))
    return total * 1024


def largest(words: list[str]) -> int:
    """Run a command; return the largest memory of its process tree."""
    process = subprocess.Popen(words, stdout=subprocess.DEVNULL)
    most = 0
    while process.poll() is None:
        most = max(most, memory(process.pid))
        time.sleep(0.05)
    assert process.returncode == 0
    return most


def main(words: list[str]) -> None:
    """Measure and print."""
    many = int(words[0]) if words else 3000
    hfield = [sys.executable, "-m", "hfield", "render", "--force"]
    with tempfile.TemporaryDirectory() as folder:
        film, raw = os.path.join(folder, "top.mp4"), os.path.join(folder, "top.raw")
        cpu([*hfield, "-o", film, "--frames", "20"])
        ours = min(cpu([*hfield, "-o", film]) for _ in range(ROUNDS))
        blurred = min(cpu([*hfield, "-o", film, "--motion-blur", "0.5"]) for _ in range(ROUNDS))
        motion = physical(clip(), None, *STORY)
        with open(raw, "wb") as out:
            for frame in frames(Scene(Model(), motion, framed(FILM_SETTINGS, Model(), motion))):
                out.write(frame.tobytes())
        encode = [ffmpeg(), "-y", "-loglevel", "error", "-f", "rawvideo", "-pix_fmt", "rgb24"]
        encode += ["-s", "640x480", "-r", "50", "-i", raw, "-vf", TO_BT709, "-pix_fmt", "yuv420p"]
        encode += FORMAT.options(Film((640, 480), 500, 50))
        theirs = min(cpu([*encode, film]) for _ in range(ROUNDS))
        print("500 frames, 640x480, mp4; CPU seconds of the process tree, least of three")
        print(f"  ffmpeg, raw frames     {theirs:6.2f}")
        for name, taken in (("hfield render", ours), ("with motion blur", blurred)):
            print(f"  {name:22} {taken:6.2f}, ratio {taken / theirs:.2f}")
        start = time.perf_counter()
        taken = cpu([*hfield, "-o", film, "--size", "1920x1080", "--jobs", "2"])
        wall = time.perf_counter() - start
        print(
            f"500 frames, 1920x1080, two processes: {500 / wall:.0f} frames/s, {taken:.1f} s of CPU"
        )
        os.remove(raw)
        if not many:
            return
        print("largest memory of the process tree, MB")
        for suffix in ("mp4", "gif"):
            sizes = [
                largest([*hfield, "-o", os.path.join(folder, f"top.{suffix}"), "--frames", str(n)])
                for n in (500, many)
            ]
            print(
                f"  {suffix}: 500 frames {sizes[0] / 1e6:.0f}, {many} frames {sizes[1] / 1e6:.0f}"
            )


if __name__ == "__main__":
    main(sys.argv[1:])
