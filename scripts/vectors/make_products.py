"""Make products.json with PARI/GP: python3 scripts/vectors/make_products.py

Needs the Debian package pari-gp. Python only draws the inputs (seeded) and writes down what gp
printed; the arithmetic is quat.gp's, in pairs over a quadratic extension.
"""

import re
from collections.abc import Iterator
from random import Random

from common import HERE, pari_version, run_gp, write_cases
from rings import RINGS, Ring

FIELDS = (("a", 1), ("b", 1), ("t", 1), ("p", 4), ("q", 4), ("product", 4))
FIELDS_P = (("norm_p", 1), ("trace_p", 1), ("conj_p", 4), ("inverse_p", 4))


def algebras(ring: Ring, rng: Random) -> Iterator[tuple[tuple[str, str, str], str]]:
    """Yield (a, b, t) and, for the split ones, a c with N(c + i) = 0."""

    def r() -> str:
        return f"({ring.sample(rng)})"

    for _ in range(2):
        yield ("-1", "-1", "0"), ""
        yield (r(), r(), "0"), ""
    yield ("0", r(), "0"), ""
    yield (r(), "0", "0"), ""
    yield ("0", "0", "0"), ""
    for _ in range(2):
        yield (r(), r(), "1"), ""
    yield ("0", r(), "1"), ""
    yield (r(), "0", "1"), ""
    yield (r(), r(), r()), ""
    for t in ("0", "1", r()):  # a = c² + t·c puts a root of i's polynomial into the ring
        c = r()
        yield (f"{c}^2+{t}*{c}", r(), t), c


def elements(ring: Ring, rng: Random, c: str) -> Iterator[tuple[list[str], list[str]]]:
    """Yield pairs p, q: random ones, special ones, and norm-zero ones where c allows."""

    def full() -> list[str]:
        return [ring.sample(rng) for _ in range(4)]

    def special() -> list[str]:
        unit = rng.randrange(4)
        return rng.choice(
            (
                ["0"] * 4,
                ["1", "0", "0", "0"],
                ["1" if n == unit else "0" for n in range(4)],
                ["-1" if n == unit else "0" for n in range(4)],
                [ring.sample(rng), "0", "0", "0"],
                ["0", *full()[1:]],
                [x if n % 2 else "0" for n, x in enumerate(full())],
                [x if n < 2 else "0" for n, x in enumerate(full())],
            )
        )

    yield full(), full()
    yield special(), full()
    yield special(), special()
    if c:  # (c + i)·(m + n·j)
        m, n = f"({ring.sample(rng)})", f"({ring.sample(rng)})"
        yield [f"{c}*{m}", m, f"{c}*{n}", n], full()
    else:
        p = full()
        yield p, (p if rng.random() < 0.3 else full())


def make(ring: Ring) -> list[dict[str, object]]:
    rng = Random(f"hfield products {ring.name}")
    calls = [
        f"case([{','.join(par)}],[{','.join(p)}],[{','.join(q)}]);"
        for par, c in algebras(ring, rng)
        for p, q in elements(ring, rng, c)
    ]
    library = (HERE / "quat.gp").read_text(encoding="utf-8")
    lines = run_gp("\n".join([library, ring.gp, *calls]))
    cases = []
    for line in dict.fromkeys(lines):
        texts = iter(re.sub(" ", "", line).split("\t"))
        case: dict[str, object] = {"ring": ring.name}
        if ring.modulus:
            case["modulus"] = ring.modulus
        for field, n in FIELDS + FIELDS_P:
            value = [next(texts, "") for _ in range(n)]
            case[field] = value if n > 1 else value[0]
        if case["inverse_p"] == ["null", "", "", ""]:
            case["inverse_p"] = None
        cases.append(case)
    return cases


if __name__ == "__main__":
    source = {
        "system": pari_version(),
        "route": "pairs u+v*j over L=R[w]/(w^2-t*w-a), multiplied as PARI polmods: "
        "(u1,v1)(u2,v2)=(u1*u2+b*v1*bar(v2),u1*v2+v1*bar(u2)); norm, trace and conjugate from bar",
        "script": "scripts/vectors/make_products.py",
    }
    write_cases("products.json", source, [case for ring in RINGS for case in make(ring)])
