"""Ramified places of (a, b | QQ) for random |a|, |b| < 10⁶: hfield against PARI in the same run.

    python benchmarks/ramification.py [NUMBER]

PARI answers through cypari2 or cypari where one is installed, else through the program `gp`; either way it
times its own loop, in its own process, on the same algebras. It factors a and b and takes `hilbert` at
every prime found and at infinity, as one does there. Every answer is compared. Prints microseconds an
algebra (best of 5) and the ratio. Without PARI the line says that it is missing.
"""

import json
import shutil
import subprocess
import sys
import time
from random import Random
from typing import Any

from hfield import QQ, QuaternionAlgebra
from hfield.fields.rationals.symbols import ramified_places_q

LIMIT = 10**6
ROUNDS = 5
RAMIFIED = (
    "ram(a,b)={my(P=Set(concat([[2],factor(abs(a))[,1]~,factor(abs(b))[,1]~])),"
    "r=[p|p<-P,hilbert(a,b,p)<0]);if(hilbert(a,b,0)<0,concat(r,0),r)}"
)
TIMED = (
    f"t=[];for(n=1,{ROUNDS},s=getwalltime();R=[ram(v[1],v[2])|v<-V];t=concat(t,getwalltime()-s))"
)


def pairs(number: int) -> list[tuple[int, int]]:
    """Return the same random algebras for both sides."""
    rng = Random(1)
    draw = lambda: rng.choice((-1, 1)) * rng.randrange(1, LIMIT)  # noqa: E731
    return [(draw(), draw()) for _ in range(number)]


def ours(algebras: list[tuple[int, int]]) -> tuple[float, list[list[int]]]:
    """Return our best time in seconds, and the places, 0 for infinity."""
    times = []
    for _ in range(ROUNDS):
        start = time.perf_counter()
        answers = [ramified_places_q(a, b) for a, b in algebras]
        times.append(time.perf_counter() - start)
    return min(times), [[0 if v == "inf" else int(v) for v in places] for places in answers]


def through_the_class(algebras: list[tuple[int, int]]) -> float:
    """Return the best time of making the algebras and asking them."""
    times = []
    for _ in range(ROUNDS):
        start = time.perf_counter()
        for a, b in algebras:
            QuaternionAlgebra(QQ, a, b).ramified_places()
        times.append(time.perf_counter() - start)
    return min(times)


def with_pari(algebras: list[tuple[int, int]]) -> tuple[str, float, list[list[int]]] | None:
    """Return which PARI answered, its best time in seconds and its places; None without PARI."""
    rows = [f"[{a},{b}]" for a, b in algebras]
    parts = [",".join(rows[n : n + 500]) for n in range(0, len(rows), 500)]
    lines = ["V=[]", *(f"V=concat(V,[{part}])" for part in parts), RAMIFIED, TIMED]
    if (pari := _in_process()) is not None:
        for line in lines:
            pari(line)
        name, best, answers = "a module", str(pari("vecmin(t)")), str(pari("R"))
    else:
        gp = shutil.which("gp")
        if gp is None:
            return None
        script = "\n".join([*lines, "print(vecmin(t))", "print(R)", ""])
        command = [gp, "-q", "-f", "-s", "256000000"]
        done = subprocess.run(command, input=script, capture_output=True, text=True, check=True)
        name, (best, answers) = "gp", done.stdout.strip().splitlines()[-2:]
    return name, int(best) / 1000, json.loads(answers)


def _in_process() -> Any:
    """Return PARI as a Python module, or None."""
    try:
        import cypari2
    except ImportError:
        try:
            from cypari import pari
        except ImportError:
            return None
    else:
        pari = cypari2.Pari()
    pari.allocatemem(2**28)
    return pari


def main(words: list[str]) -> None:
    """Print one line a way."""
    number = int(words[0]) if words else 20_000
    algebras = pairs(number)
    seconds, places = ours(algebras)
    whole = through_the_class(algebras)
    scale = 1e6 / number
    print(f"{number} algebras (a,b|QQ), 0 < |a|, |b| < {LIMIT}; microseconds an algebra")
    print(f"  hfield, places from a and b      {seconds * scale:7.1f}")
    print(f"  hfield, making the algebra too   {whole * scale:7.1f}")
    found = with_pari(algebras)
    if found is None:
        print("  PARI is missing: install cypari, cypari2 or the program gp to compare")
        return
    name, pari_seconds, pari_places = found
    assert places == [
        [*sorted(p for p in row if p), *(p for p in row if not p)] for row in pari_places
    ]
    print(f"  PARI through {name:<8}            {pari_seconds * scale:7.1f}")
    ratios = f"{seconds / pari_seconds:7.2f} (making the algebra too: {whole / pari_seconds:.2f})"
    print(f"  ratio, hfield to PARI            {ratios}")


if __name__ == "__main__":
    main(sys.argv[1:])
