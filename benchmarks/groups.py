"""Dirichlet domains beside Rickards's contributed program for PARI (C), in one run.

    python benchmarks/groups.py FOLDER

FOLDER holds ``fdom.gp`` and ``libfdom.so`` of JamesRickards-Canada/Fundamental-Domains-for-Shimura-curves,
built against this machine's libpari (before PARI 2.17 its three calls of ``gen_search`` need the older
arguments). Ours includes the proof; the other works in floats of 38 digits. Times are the least of several, in
milliseconds; that of a maximal order is in neither.
"""

import re
import subprocess
import sys
import time

from hfield import QuaternionAlgebra

SIZES = (3, 7, 23, 71, 239)
TIMES = 7
SCRIPT = """read("fdom.gp");
{foreach([%s], a, my(A, d, s, best = 10^9); A = alginit(nfinit(y), [a, -1]);
  for(k = 1, %d, s = getabstime(); d = algfdom(A, I/2); best = min(best, getabstime() - s));
  print("RESULT ", a, " ", #d[1], " ", best))}
"""


def theirs(folder: str) -> dict[int, tuple[int, float]]:
    script = SCRIPT % (", ".join(map(str, SIZES)), TIMES)
    found = subprocess.run(
        ["gp", "-q"], input=script, cwd=folder, capture_output=True, text=True, check=True
    )
    rows = re.findall(r"RESULT (\d+) (\d+) (\d+)", found.stdout)
    return {int(a): (int(sides), float(ms)) for a, sides, ms in rows}


def ours(a: int) -> tuple[int, float]:
    best = 1e9
    for _ in range(TIMES):
        order = QuaternionAlgebra("QQ", a, -1).maximal_order()
        begun = time.process_time()
        sides = len(order.norm_one_group().domain().sides)
        best = min(best, 1000 * (time.process_time() - begun))
    return sides, best


def main() -> None:
    peers = theirs(sys.argv[1]) if len(sys.argv) > 1 else {}
    ours(3)  # imports
    for a in SIZES:
        sides, ms = ours(a)
        line = f"({a},-1|QQ): {sides} sides, {ms:.1f} ms"
        if a in peers:
            line += f"; theirs {peers[a][0]} sides, {peers[a][1]:.0f} ms, ratio {ms / max(peers[a][1], 1):.2f}"
        print(line)


if __name__ == "__main__":
    main()
