"""The implementations that the benchmark measures: this package, other libraries, plain numpy, the thesis.

Preparations that do not depend on the angles, such as a memory layout or lists, are made before the first
frame and not timed. Computations that depend on the angles of the frame are timed.
"""

from rotation.bench.ways.other_libraries import PEERS
from rotation.bench.ways.ours import OURS
from rotation.bench.ways.plain import PLAIN
from rotation.bench.ways.printed import PRINTED
from rotation.bench.ways.way import Way

WAYS: tuple[Way, ...] = (*PLAIN[:1], *OURS, *PEERS, *PLAIN[1:], *PRINTED)

__all__ = ["WAYS", "Way"]
