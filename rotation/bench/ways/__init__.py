"""The ways to rotate that the benchmark measures: ours, other libraries, plain numpy, the thesis's.

What can be laid out once before the first frame is, for every way: a layout of its own, lists, the
points as quaternions. What depends on the frame's angles is inside the time.
"""

from rotation.bench.ways.other_libraries import PEERS
from rotation.bench.ways.ours import OURS
from rotation.bench.ways.plain import PLAIN
from rotation.bench.ways.printed import PRINTED
from rotation.bench.ways.way import Way

WAYS: tuple[Way, ...] = (*PLAIN[:1], *OURS, *PEERS, *PLAIN[1:], *PRINTED)

__all__ = ["WAYS", "Way"]
