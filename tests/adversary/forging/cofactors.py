"""Forged implications: items that would prove a false claim if some rule of arithmetic or logic gave way.

Each function draws one lie; the rest of the evidence is made so that everything else is in order.
"""

import random
from collections.abc import Callable
from typing import Any

from tests.adversary.forging.targets import Target
from tests.checker.ring_data import INFINITY, number, prime, split

Item = dict[str, Any]
DIGITS = (8, 10, 12, 15, 16, 20, 24, 31, 32)  # where an exponent might be cut off
COMPOSITE = (4, 6, 8, 9, 15, 25, 91, 561, 3215031751, 341550071728321)


def huge(variable: str, exponent: int, rng: random.Random) -> str:
    """Write variable**exponent as a product of powers that may each be written."""
    chunk = rng.choice((65536, 65535, 32768, 999_999, 10_000))
    count, rest = divmod(exponent, chunk)
    if count > 6_000:
        return f"{variable}**{exponent}"
    parts = [f"{variable}**{chunk}"] * count + ([f"{variable}**{rest}"] if rest else [])
    return "*".join(parts) or "1"


def names(target: Target) -> tuple[str, ...]:
    """Return variables to speak of; there is always one."""
    return (*target.variables, *target.constants) or ("s",)


def direct(
    member: str, zero: list[str], relations: list[str], cofactors: list[str], **more: Any
) -> Item:
    """Return an item that shows a member."""
    return {
        "characteristic": 0,
        "zero": zero,
        "relations": relations,
        "member": member,
        "cofactors": cofactors,
        "denominator": 1,
    } | more


def indirect(nonzero: list[str], steps: list[Any], **more: Any) -> Item:
    """Return an item that ends in a contradiction."""
    return {
        "characteristic": 0,
        "zero": [],
        "relations": [],
        "nonzero": nonzero,
        "steps": steps,
    } | more


def contradiction(cofactors: list[str], denominator: int = 1) -> dict[str, Any]:
    """Return the step that ends an item."""
    return {"step": "contradiction", "cofactors": cofactors, "denominator": denominator}


def _goal(target: Target, rng: random.Random) -> str:
    return rng.choice(target.goals) if target.goals else "1"


def overflow_relation(target: Target, rng: random.Random) -> list[Item]:
    """A power so large that it reads as T1, or as nothing: "T1 = 1" contradicts 1 = 2·T1."""
    bits = rng.choice(DIGITS)
    variable = rng.choice((names(target)[-1], rng.choice(names(target))))
    exponent = (1 << bits) * rng.choice((1, 1, 1, 2, 3)) + rng.choice((0, 0, 0, 1, -1))
    relation = f"{huge(variable, exponent, rng)} - 1"
    nonzero = ["2"] if rng.random() < 0.7 else ["2", *target.goals[:2]]
    steps = [contradiction(["-2", "-1", *["0"] * (len(nonzero) - 1)])]
    return [indirect(nonzero, steps, relations=[relation])]


def overflow_member(target: Target, rng: random.Random) -> list[Item]:
    """A cofactor whose product with a zero carries into the next variable."""
    bits, variable, goal = rng.choice(DIGITS), rng.choice(names(target)), _goal(target, rng)
    power = huge(variable, (1 << bits) - rng.choice((0, 1, 2)), rng)
    zero = [rng.choice((*target.zeros, variable, f"{power} - 1", power))]
    cofactor = rng.choice((power, f"{power} - {variable}", f"-{power}", "1"))
    return [direct(goal, zero, [], [cofactor], denominator=rng.choice((1, -1)))]


def coefficient(target: Target, rng: random.Random) -> list[Item]:
    """Numbers that are 0 or 1 in 32 or 64 bits, or as floats."""
    n = rng.choice((2**31, 2**32, 2**53, 2**63, 2**64, 10**400, 10**3999))
    goal = _goal(target, rng)
    item = rng.choice(
        (
            direct(goal, [str(n)], [], ["0"]),
            direct(goal, [], [f"{n} - {n + 1} + 1"], [goal]),
            direct(goal, list(target.zeros), [], [str(n)] * len(target.zeros), denominator=n),
            direct(f"{n}*{_bracketless(goal)}", [], [], [], denominator=1),
            direct(goal, [], [str(n)], [goal], denominator=n),
        )
    )
    return [item]


def _bracketless(f: str) -> str:
    return f.split(" ")[0].lstrip("-")


def denominator(target: Target, rng: random.Random) -> list[Item]:
    """A denominator that is 0, or 0 in the field: 0·g is always a sum."""
    p = next(
        (
            int(n)
            for n in (target.field or "").replace("ZZ/", "GF(")[3:].split(")")[:1]
            if n.isdigit()
        ),
        2,
    )
    d = rng.choice((0, p, -p, p * p, 2 * p, 6, 12, 0, 2**64, 30_030))
    zeros = list(target.zeros)
    made = []
    for goal in target.goals or ("1",):
        cofactors = ["0"] * len(zeros)
        if rng.random() < 0.4 and zeros:
            cofactors[0] = rng.choice(("1", str(d), "0"))
        made.append(
            direct(
                goal, zeros, [], cofactors, denominator=d, characteristic=rng.choice((0, 0, p, 2))
            )
        )
    if rng.random() < 0.3:
        steps = [contradiction([*["0"] * len(zeros), "0"], d)]
        made = [indirect(list(target.goals[:1]) or ["1"], steps, zero=zeros)]
    return made


def characteristic(target: Target, rng: random.Random) -> list[Item]:
    """An item for a characteristic that is not a prime, or not the field's; modulo it, 1 is a sum."""
    c = rng.choice((*COMPOSITE, 2, 3, 5, 7, 1, -1, -2, 2**61 - 1, 10**30))
    goal = _goal(target, rng)
    items = [direct(goal, [], [str(c)], [goal], characteristic=c)]
    items.append(direct(f"{abs(c)}*{_bracketless(goal)}", [], [], [], characteristic=c))
    items.append(
        indirect(list(target.goals) or ["1"], [contradiction(["1"] * 1, 1)], characteristic=c)
    )
    items.append(
        direct(
            goal,
            list(target.zeros),
            [],
            ["0"] * len(target.zeros),
            characteristic=c,
            denominator=c if c > 1 else 1,
        )
    )
    return rng.sample(items, rng.randint(1, len(items)))


def relation(target: Target, rng: random.Random) -> list[Item]:
    """A relation that does not hold in the field."""
    x, goal = rng.choice(names(target)), _goal(target, rng)
    lie = rng.choice(
        (
            *(
                "1",
                goal,
                f"{x} - 1",
                x,
                f"{x}**2 - 1",
                f"{x}**2 + 1",
                "T1 - 1",
                "T1",
                "2",
                "0*T1 + 1",
            ),
            *(
                f"{x}**65536 - {x}",
                f"{x}**2 - {x}",
                f"{x} - {x} + 1",
                "- 1",
                "+1",
                "1*1",
                f"2*{x} - {x}",
            ),
        )
    )
    cofactor = goal if lie in ("1", "1*1", "+1") else rng.choice(("1", "-1", goal, f"{x} + 1"))
    made = [
        direct(g, [], [lie], [g if cofactor == goal else cofactor]) for g in target.goals or ("1",)
    ]
    if rng.random() < 0.3:
        made = [indirect(["1"], [contradiction(["1", "0"])], relations=[lie])]
    return made


def zero(target: Target, rng: random.Random) -> list[Item]:
    """Zeros that are none of the clause's, or only nearly: multiples, sums, parts of them."""
    x = rng.choice(names(target))
    made = []
    for goal in target.goals or ("1",):
        own = rng.choice(target.zeros) if target.zeros else "0"
        lie = rng.choice(
            (
                *("1", goal, f"2*{_bracketless(goal)}", f"{own} + 1", f"{own} - {x}", "2", "0", x),
                *(f"{own} - {own} + {_bracketless(goal)}", f"3*{_bracketless(goal)}"),
            )
        )
        cofactor, d = {goal: ("1", 1), "1": (goal, 1)}.get(lie, ("1", rng.choice((1, 2, 3))))
        made.append(direct(goal, [lie], [], [cofactor], denominator=d))
    return made[: rng.randint(1, len(made))]


def nonzero(target: Target, rng: random.Random) -> list[Item]:
    """Something called "not 0" that may be 0: then its inverse T1 gives 1 = 0."""
    x = rng.choice(names(target))
    lie = rng.choice(("0", x, f"{x} - {x}", "2", "3", "1", f"{x}**2", f"{x} + 1", *target.zeros))
    return rng.choice(
        (
            [indirect([lie], [contradiction(["1"])])],
            [indirect([lie], [contradiction(["1", "T1"])], zero=[lie])],
            [indirect([], [contradiction([])])],
            [indirect([], [contradiction(["1"])], zero=["1"])],
            [indirect([lie, lie], [contradiction(["1", "-1"])])],
            [indirect(list(target.goals), [contradiction(["0"] * len(target.goals), 0)])],
            [],
        )
    )


def steps(target: Target, rng: random.Random) -> list[Item]:
    """Steps that end without a contradiction, branch without covering, or use what is not there."""
    zeros, goals = list(target.zeros), list(target.goals[:1]) or ["1"]
    known = len(zeros) + len(goals)
    none = ["0"] * known
    x = rng.choice(names(target))
    four = [rng.choice((x, "0", "1", goals[0])) for _ in range(4)]
    lie: list[Any] = rng.choice(
        (
            [],
            [
                {
                    "step": "cases",
                    "cofactors": none,
                    "denominator": 1,
                    "factors": ["0"],
                    "powers": [1],
                    "branches": [[]],
                }
            ],
            [
                {
                    "step": "cases",
                    "cofactors": none,
                    "denominator": 0,
                    "factors": ["1"],
                    "powers": [1],
                    "branches": [[contradiction([*none, "1"])]],
                }
            ],
            [
                {
                    "step": "cases",
                    "cofactors": none,
                    "denominator": 1,
                    "factors": [],
                    "powers": [],
                    "branches": [],
                }
            ],
            [
                {
                    "step": "cases",
                    "cofactors": none,
                    "denominator": 1,
                    "factors": ["0", "1"],
                    "powers": [1, 0],
                    "branches": [[contradiction([*none, "0"], 0)], [contradiction([*none, "1"])]],
                }
            ],
            [
                {"step": "norm", "cofactors": none, "denominator": 1, "terms": four},
                contradiction([*none, *["1"] * 4]),
            ],
            [
                {
                    "step": "norm",
                    "cofactors": ["1", *none[1:]],
                    "denominator": 1,
                    "terms": list(target.goals)[:4] * 4,
                },
                contradiction([*none, "T1", *none]),
            ],
            [
                {
                    "step": "squares",
                    "cofactors": ["1", *none[1:]],
                    "denominator": 1,
                    "terms": list(target.variables[:2]) or ["1"],
                    "coefficients": rng.choice(([1, 1], [1, -1], [0, 1], [1], [1, 1, 1])),
                },
                contradiction([*none, "T1", *none][: known + 2]),
            ],
            [
                {
                    "step": "no root",
                    "cofactors": ["1", *none[1:]],
                    "denominator": 1,
                    "polynomial": rng.choice(
                        (*target.zeros, x, f"{x}**2 - 1", f"{x}**2 - 2", "0", "1", "T1")
                    ),
                }
            ],
            [contradiction(["1", *none[1:]])],
            [contradiction(none), contradiction(none)],
        )
    )
    return [indirect(goals, lie, zero=zeros)]


UNIT_I, UNIT_J, HALF, ZERO = ["0", "1", "0", "0"], ["0", "0", "1", "0"], ["1/2"] * 4, ["0"] * 4
FACTS: tuple[Any, ...] = (
    {"form": "norm", "by": "ordering"},
    {"form": "norm", "by": "level"},
    *(
        {"form": "norm", "by": "place", "place": p, "u": UNIT_I, "j": UNIT_J}
        for p in (number(3), number(15), prime(0, 1), INFINITY)
    ),
    *(
        {"form": "norm", "by": "place", "place": p, "u": HALF, "j": ["1", "1", "0", "0"]}
        for p in (number(2), number(4), number("3"))
    ),
    {
        "form": "norm",
        "by": "place",
        "place": split(2, 1),
        "u": HALF,
        "j": ["1", "1", "0", "0"],
    },
    {"form": "norm", "by": "place", "place": number(2), "u": ZERO, "j": ZERO},
    {"form": "norm", "by": "place", "place": number(9), "u": UNIT_I, "j": ["3", "0", "0", "0"]},
    {"form": "norm", "by": "specialisation", "at": "0", "proof": {"by": "ordering"}},
    {
        "form": "norm",
        "by": "place",
        "place": number(2),
        "u": HALF,
        "j": UNIT_I,
        "algebra": "(-1,-1|QQ)",
    },
    {"form": "norm", "by": "ordering", "algebra": "(-1,-1|RR)"},
    {"form": "squares", "by": "level", "most": 2, "positive": False},
    {"form": "squares", "by": "level", "most": 5, "positive": False},
    {"form": "squares", "by": "ordering", "most": None, "positive": True},
    {"form": "squares", "by": "level", "most": 1, "positive": True},
    {"form": "roots", "by": "squares"},
    {"form": "roots", "by": "factors"},
)
LIES: tuple[Callable[[Target, random.Random], list[Item]], ...] = (
    *(
        overflow_relation,
        overflow_relation,
        overflow_member,
        coefficient,
        denominator,
        characteristic,
    ),
    *(relation, zero, nonzero, steps, steps),
)


def implication(target: Target, rng: random.Random) -> tuple[str, Any]:
    """Return the name of the lie and the forged evidence."""
    lie = rng.choice(LIES)
    items = lie(target, rng)
    if rng.random() < 0.15:
        items = items + rng.choice(LIES)(target, rng)
    if lie is steps or rng.random() < 0.1:
        facts = [dict(f) for f in rng.sample(FACTS, rng.randint(1, 3))]
    else:
        facts = []
    return lie.__name__, {"kind": "implication", "facts": facts, "items": items}
