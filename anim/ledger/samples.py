"""Section 3.4: numpy's ``linspace`` and the points computed from its values."""

from collections.abc import Callable
from fractions import Fraction
from inspect import Parameter, signature

from anim.ledger.counting import RING
from hfield.ledger.claim import Computed, ComputedResult
from hfield.ledger.document import Propositions

# The calls of sections 3.4 and 3.4.1, as start, stop and num; angles in units of π.
CALLS = ((0, 2, 1000), (0, 32, 500), (16, Fraction(1, 8), 500), (0, Fraction(1, 4), 500))
ROUNDING = 2.0**-50
"""How far, relative to the ends, rounding may move a value that is the result of a few operations."""


def parameters(all_of_them: int, needed: int) -> Computed:
    """Return the claim for the number of positional arguments of ``linspace``, with defaults for all but the
    first.

    ``needed`` are the arguments that the thesis gives.
    """

    def check_claim() -> ComputedResult:
        from numpy import linspace

        found = signature(linspace).parameters.values()
        placed = [p for p in found if p.kind is not Parameter.KEYWORD_ONLY]
        optional = [p.name for p in placed[needed:] if p.default is not Parameter.empty]
        named = [p.name for p in found if p.kind is Parameter.KEYWORD_ONLY]
        steps = (
            f"by position: {', '.join(p.name for p in placed)}",
            f"by name only: {', '.join(named) or 'none'}",
            f"optional after the first {needed}: {', '.join(optional)}",
        )
        holds = len(placed) == all_of_them and len(optional) == all_of_them - needed
        return ComputedResult(holds, steps, {"arguments": [str(len(placed))]})

    rest = all_of_them - needed
    return Computed(
        f"linspace takes {all_of_them} arguments by position; {rest} may be left out", check_claim
    )


def spaced(steps: Callable[[int], int], interval: str) -> Computed:
    """Return the claim that ``linspace`` returns ``num`` numbers, the n-th at n steps from the start.

    ``steps`` returns the number of steps of the interval as a function of ``num``. The claim is checked for
    all values that the thesis uses, up to rounding.
    """

    def check_claim() -> ComputedResult:
        from numpy import linspace

        found, holds = [], True
        for start, stop, num in CALLS:
            values = linspace(float(start), float(stop), num)
            exact = [start + Fraction(stop - start) * n / steps(num) for n in range(num)]
            most = max(abs(Fraction(x) - y) for x, y in zip(values.tolist(), exact, strict=False))
            holds = holds and len(values) == num and most <= ROUNDING * max(start, stop)
            found.append(
                f"linspace({start}, {stop}, {num}): {len(values)} numbers from {values[0]:g} to "
                f"{values[-1]:g}, at most {float(most):.1e} from their places"
            )
        return ComputedResult(holds, tuple(found))

    return Computed(f"linspace returns num equally spaced numbers of {interval}", check_claim)


def circle_points(different: bool) -> Computed:
    """Return the claim that ``linspace(0, 2π, 1000)`` gives 1000 points per circle, or that they are
    distinct.
    """

    def check_claim() -> ComputedResult:
        import numpy as np

        from anim.model import READINGS

        angles = np.linspace(0, 2 * np.pi, RING)
        circle = np.column_stack([np.cos(angles), np.sin(angles)])
        off = max(
            float(abs(np.sum((radius * circle) ** 2, axis=1) - radius**2).max())
            for radius in (1.0, READINGS["printed"])
        )
        # The n-th angle is n/999 of a full turn.
        places = {Fraction(n, RING - 1) % 1 for n in range(len(angles))}
        count = len(places) if different else len(angles)
        steps = (
            f"{len(angles)} angles, {len(places)} of them different up to full turns",
            f"the points are on x² + y² = 1 and (1/3)³ up to {off:.1e}",
        )
        return ComputedResult(
            count == RING and off < ROUNDING, steps, {"different": [str(len(places))]}
        )

    which = "different points" if different else "points"
    return Computed(
        f"linspace(0, 2π, {RING}) gives {RING} {which} on each of P1 and P2", check_claim
    )


COMPUTED = {
    "C3.4-a": Propositions(as_printed=parameters(7, 3), spoilt=parameters(8, 3)),
    "C3.4-b": Propositions(
        as_printed=spaced(lambda num: num - 1, "[start, stop]"),
        spoilt=spaced(lambda num: num, "[start, stop)"),
    ),
    "C3.4-c": Propositions(
        as_printed=circle_points(different=False), spoilt=circle_points(different=True)
    ),
}
