"""Make the files on division over number fields: python3 scripts/vectors/make_symbols.py

Writes hilbert.json, ramification.json and quadratic_division.json. Needs the Debian package
pari-gp. Python only draws the inputs (seeded); symbols.gp decides, and stops where two ways differ.
"""

import json
from itertools import product
from random import Random

from common import HERE, pari_version, run_gp, write_cases


def decide(calls: list[str]) -> list[dict[str, object]]:
    library = (HERE / "symbols.gp").read_text(encoding="utf-8")
    return [json.loads(line) for line in dict.fromkeys(run_gp("\n".join([library, *calls])))]


def nonzero(rng: Random, size: int) -> int:
    return rng.choice((-1, 1)) * rng.randint(1, size)


def rational(rng: Random, size: int) -> str:
    return f"{nonzero(rng, size)}/{rng.randint(1, size)}"


def hilbert() -> list[dict[str, object]]:
    rng = Random("hfield hilbert")
    calls = []
    dyadic = [f"{u}*2^{n}" for u in (1, 3, 5, 7) for n in range(4)]
    calls += [f"near({a},0,{b},0,2);" for a, b in product(dyadic, repeat=2)]
    for _ in range(250):  # other representatives of the classes, by odd squares and signs
        a, b = (f"{nonzero(rng, 10**5)}*2^{rng.randint(-5, 5)}" for _ in "ab")
        calls.append(f"near({a},0,{b},0,2);")
    for p in (3, 5, 7, 11, 13):
        classes = [(u, n) for u in (1, -1, 2 if p in (3, 5, 11, 13) else 3) for n in range(3)]
        calls += [f"near({u},{n},{v},{m},{p});" for (u, n), (v, m) in product(classes, repeat=2)]
    for _ in range(550):
        e, f = rng.randint(-2, 3), rng.randint(-2, 3)
        a, b = f"{nonzero(rng, 10**6)}", rational(rng, 1000)
        calls.append(f"near({a},{e},{b},{f},{rng.randint(2, 999_900)});")
    for n in range(130):  # every place where the symbol can be -1, so the product formula shows
        a, b = (rational(rng, 10 ** (1 + n % 6)) for _ in "ab")
        calls.append(f"symbols({a},{b});")
    return decide(calls)


def ramification() -> list[dict[str, object]]:
    rng = Random("hfield ramification")
    pairs = [(a, b) for a in range(-7, 8) for b in range(a, 8) if a and b]
    pairs += [(4, 3), (3, 4), (9, -1), (-1, 25), (-4, -9), (10**6, 7), (-(10**6), -1), (7, 7)]
    for n in range(610 - len(pairs)):
        size = 10 ** (2 + n % 5)
        a, b = nonzero(rng, size), nonzero(rng, size)
        if n % 7 == 0:  # split by design: b = -a·c², so i·c + j squares to 0
            c = rng.randint(1, 9)
            a, b = a % 9999 + 1, -(a % 9999 + 1) * c * c
        elif n % 7 == 1:
            a = rng.randint(1, 1000) ** 2
        pairs.append((a, b))
    return decide([f"ramification({a},{b});" for a, b in pairs])


def squarefree(d: int) -> bool:
    return all(d % (n * n) for n in range(2, 9))


def quadratic() -> list[dict[str, object]]:
    rng = Random("hfield quadratic")
    fields = [d for d in range(-60, 61) if d not in (0, 1) and squarefree(d)]
    calls = [f"quadratic({d},[-1,0],[-1,0]);" for d in fields]
    for n in range(160):
        d = rng.choice(fields)
        size, bottom = (6, 1) if n % 4 else (9, rng.choice((2, 3)))
        a, b = ([f"{nonzero(rng, size)}/{bottom}", f"{rng.randint(-4, 4)}"] for _ in "ab")
        if n % 3 == 0:
            a[1] = b[1] = "0"
        elif n % 3 == 1:
            b[1] = "0"
        norm = ",1" if n % 5 == 0 else ""
        calls.append(f"quadratic({d},[{','.join(a)}],[{','.join(b)}]{norm});")
    return decide(calls)


if __name__ == "__main__":
    source = {"system": pari_version(), "script": "scripts/vectors/make_symbols.py"}
    route = {"route": "hilbert(a, b, p)"}
    write_cases("hilbert.json", source | route, hilbert())
    route = {"route": "hilbert at inf and every prime of 2ab; agrees with alginit and qfsolve"}
    write_cases("ramification.json", source | route, ramification())
    route = {"route": "nfhilbert over the field; agrees with rnfisnorm and algisdivision(alginit)"}
    write_cases("quadratic_division.json", source | route, quadratic())
