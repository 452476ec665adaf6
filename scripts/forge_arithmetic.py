"""Forge certificates about class groups, units, orders, their classes and newforms; see that no lie passes.

    python scripts/forge_arithmetic.py [--seconds 60] [--seed 0] [--only newforms]

Genuine certificates get a false statement, and one to three changes of their evidence: numbers, entries left
out, doubled or exchanged, parts of other certificates. What is stated is false because the genuine statement
is true. Exit status 1 when a false one passes; an error that is no rejection ends it.
"""

import argparse
import random
import re
import sys
import time
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).parents[1]))

from hfield import QuaternionAlgebra, ring
from hfield.checker.check import Budget, Rejected, check
from hfield.orders import certificates

FIELDS = (
    "QQ(sqrt(-21))", "QQ(sqrt(5))", "QQ(sqrt(82))", "QQ(zeta5)", "QQ(root(7,3))", "QQ(sqrt(-5))",
    "QQ[s]/(s^3-s^2-2*s+1)", "QQ[s]/(s^3-s^2-2*s-8)", "QQ[s]/(s^4-s^2+4)", "QQ(sqrt(-1))",
)  # fmt: skip
INDEFINITE = ((3, -1, 1), (1, 1, 1), (1, 1, 6), (-1, 3, 5), (5, 2, 1))
OVER_FIELDS = ("(-1,sqrt(5)|QQ(sqrt(5)))", "(-1+s-s^2,1+3*s+s^2|QQ[s]/(s^3+s^2-2*s-1))")
DEFINITE = ("QQ(sqrt(5))", "QQ(sqrt(17))", "QQ(sqrt(29))", "QQ[s]/(s^3-s^2-2*s+1)")

NEWFORMS = (
    (43, 1, 5, 2),
    (11, 3, 7, 2),
    (2, 45, 7, 2),
    (3, 16, 7, 2),
    ("(-1,-1|QQ(sqrt(5)))", "6 + sqrt(5)", 5, 2),
    (7, 3, 5, 4),
    (11, 1, 5, 6),
    (2, 9, 7, 8),
    ("(-1,-1|QQ(sqrt(10)))", 1, 3, 2),
)
POLYNOMIALS = (
    ("GF(3)(t)", "t^3+2*t+1", 1),
    ("GF(2)(t)", "t^3+t+1", "t"),
    ("GF(4)(t)", "t^2+t+x", "t"),
)


def genuine() -> list[dict[str, Any]]:
    """Return a certificate of each kind and of each field and algebra."""
    found = []
    for name in FIELDS:
        K = ring(name)
        found += [K.class_group().certificate, K.unit_group().certificate]
    for a, b, level in INDEFINITE:
        order = QuaternionAlgebra("QQ", a, b).eichler_order(level)
        G = order.norm_one_group()
        found += [G.certificate, G.domain().certificate]
        found += [G.domain(point).certificate for d in (-3, -4) for point in G.cm_points(d)[:1]]
        found += [order.embeddings(d).claim_of_orbits().certificate for d in (-7, -8, -24)]
    for text in OVER_FIELDS:
        G = QuaternionAlgebra.from_text(text).maximal_order().norm_one_group()
        found += [G.certificate, G.domain().certificate]
    for name in DEFINITE:
        A = QuaternionAlgebra(name, -1, -1)
        found += [O.class_set().certificate for O in (A.maximal_order(), A.order(["i", "j"]))]
    for algebra, level, norm, weight in NEWFORMS:
        C = QuaternionAlgebra(algebra).eichler_order(level).class_set()
        found += [C.claim_of_newforms(weight, norm, signs).certificate for signs in (False, True)]
    for name, prime, level in POLYNOMIALS:
        A = QuaternionAlgebra.from_ramification(name, [prime, "inf"])
        O = A.eichler_order(level)
        C = O.class_set()
        I, x = list(C)[-1], A(1, 1, 0, 1)
        moved = (x * O * x.inverse()).left_order()
        found += [O.certificate, C.certificate, I.certificate, I.is_principal().certificate]
        found += [O.isomorphism(P).certificate for P in (moved, I.left_order())]
        found.append(certificates.of_unit_index(O.value, O.unit_index()).certificate)
    return [data for data in found if data is not None]


def changed(rng: random.Random, value: Any) -> Any:
    """Return a copy of JSON data with one change at one place."""
    if isinstance(value, dict):
        keys = [k for k in value if k != "kind"]
        if not keys:
            return {"kind": "integers"}
        key = rng.choice(keys)
        return {**value, key: changed(rng, value[key])}
    if isinstance(value, list) and value:
        n, m, how = rng.randrange(len(value)), rng.randrange(len(value)), rng.randrange(10)
        if how == 0:
            return [*value[:n], *value[n + 1 :]]
        if how == 1:
            return [*value, value[n]]
        if how == 2:
            out = list(value)
            out[n], out[m] = out[m], out[n]
            return out
        return [*value[:n], changed(rng, value[n]), *value[n + 1 :]]
    if isinstance(value, int):
        return rng.choice([value + 1, value - 1, -value, 2 * value, 0, 1])
    if not isinstance(value, str):
        return [0]
    if "," in value:
        separator = " | " if " | " in value and rng.randrange(4) else ","
        return separator.join(changed(rng, value.split(separator)))
    return rng.choice(["1/2", "-1/2", "3/2", "2", "-1", "t", "1/t"])


def lies(rng: random.Random, data: dict[str, Any]) -> Iterator[str]:
    """Yield statements that the genuine one makes false."""
    word, _, inside = data["statement"][:-1].partition("{")
    parts = inside.split("; ")
    if word == "class-group":
        yield from (
            f"class-group{{{x}}}" for x in ("1", "2", "3", "4", "2,2", "5", "2,4") if x != inside
        )
    elif word == "unit-group":
        yield f"unit-group{{{'; '.join([str(2 * int(parts[0])), *parts[1:]])}}}"
        if len(parts) > 1:
            power = f"({parts[-1]})^{rng.choice([2, 3, -2, 5])}"
            yield f"unit-group{{{'; '.join([*parts[:-1], power])}}}"
            yield f"unit-group{{{'; '.join(parts[:-1])}}}"
    elif word.startswith("norm-one-group"):
        wrong = {
            1: str(int(parts[1]) + 1),
            2: parts[2] + ",7",
            3: str(int(parts[3]) + 1),
            5: "1 1 1 1 1",
        }
        for n, text in wrong.items():
            yield f"{word}{{{'; '.join([*parts[:n], text, *parts[n + 1 :]])}}}"
    elif word in ("order-over-polynomials", "ideal-over-polynomials"):
        for n in (f"({parts[-1]})*(t+1)", f"({parts[-1]})/(t^4+t)", "t^7"):
            yield f"{word}{{{'; '.join([*parts[:-1], n])}}}"
    elif word == "equivalent-over-polynomials" and data["verdict"] == "refuted":
        yield f"{word}{{{'; '.join([*parts[:2], parts[1]])}}}"
    elif word == "isomorphic-over-polynomials" and data["verdict"] == "refuted":
        yield f"{word}{{{'; '.join([parts[0], parts[0]])}}}"
    elif word in ("ideal-classes", "class-set-over-polynomials", "unit-index-over-polynomials"):
        for h in (int(parts[1]) + 1, int(parts[1]) - 1, 2 * int(parts[1])):
            if h > 0:
                yield f"{word}{{{parts[0]}; {h}}}"
    elif word == "embedding-orbits":
        for n in (int(parts[2]) + 2, int(parts[2]) - 2, 2 * int(parts[2])):
            yield f"{word}{{{parts[0]}; {parts[1]}; {n}}}"
    elif word.startswith("newforms"):
        orbits = parts[3].split(" | ")
        m = rng.choice(list(re.finditer(r"\d+", parts[3])))
        wrong = rng.choice([int(m[0]) + 1, 2 * int(m[0]) + 3, 0])
        for text in (
            f"{parts[3][: m.start()]}{wrong}{parts[3][m.end() :]}",
            " | ".join(orbits[1:]) or "none",
            " | ".join([*orbits, orbits[0]]),
            "QQ: " + ",".join("3468"[: orbits[0].count(",") + 1]),
        ):
            if text != parts[3]:
                yield f"{word}{{{'; '.join([*parts[:3], text, *parts[4:]])}}}"
        if len(parts) > 4:
            m = rng.choice(list(re.finditer("-?1", parts[5])))
            other = "1" if m[0] == "-1" else "-1"
            yield f"{word}{{{'; '.join([*parts[:5], parts[5][: m.start()] + other + parts[5][m.end() :]])}}}"
    elif word.startswith("dirichlet-domain"):
        units = parts[2].split(" | ")
        yield f"{word}{{{'; '.join([*parts[:2], ' | '.join(units[1:])])}}}"


def main() -> int:
    """Run and report."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--seconds", type=float, default=60)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--only", default="", help="the beginning of the words of statements")
    args = parser.parse_args()
    rng = random.Random(args.seed)
    every = [data for data in genuine() if data["statement"].startswith(args.only)]
    tally: Counter[str] = Counter()
    breaks = []
    end = time.monotonic() + args.seconds
    while time.monotonic() < end:
        data = rng.choice(every)
        other = rng.choice([x for x in every if x["evidence"]["kind"] == data["evidence"]["kind"]])
        evidence = data["evidence"]
        keys = [k for k in evidence if k != "kind"]
        shared = [k for k in keys if k in other["evidence"]]
        if rng.randrange(6) == 0 and shared:
            key = rng.choice(shared)
            evidence = {**evidence, key: other["evidence"][key]}
        for _ in range(rng.randint(0, 3) if keys else 0):
            evidence = changed(rng, evidence)
        statement = rng.choice([*lies(rng, data), data["statement"]])
        forged = {**data, "statement": statement, "evidence": evidence}
        lie = statement != data["statement"]
        kind = f"{data['statement'].partition('{')[0]}, {'a lie' if lie else 'the truth'}"
        try:
            check(forged, None, Budget(5))
        except Rejected:
            tally[f"{kind}: rejected"] += 1
            continue
        tally[f"{kind}: accepted"] += 1
        if lie:
            breaks.append(forged)
    for what, number in sorted(tally.items()):
        print(f"{number:8} {what}")
    print(f"{sum(tally.values()):8} forgeries, {len(breaks)} breaks")
    for forged in breaks[:5]:
        print("---", str(forged)[:600])
    return int(bool(breaks))


if __name__ == "__main__":
    sys.exit(main())
