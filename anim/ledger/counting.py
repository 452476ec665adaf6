"""Claims that count: parts of the model, variables of functions, frames of a film.

Everything is counted by running or inspecting the package; code that loads numpy does so only when needed.
"""

from collections.abc import Sequence
from inspect import signature

from hfield.ledger.claim import Computed, ComputedResult
from rotation import thesis

RING = 1000
"""The number of points that the final model takes from each of the circles (3.3, 3.4)."""
SHOWN = (0, 49, 99, 149, 199, 249, 299, 349, 399, 449)
"""The frames named under figures 3.3 and 3.4."""


def model_has(count: int, what: str, ring: int = RING) -> Computed:
    """Return the claim that the model with ``ring`` points per circle has so many parts of a kind.

    ``what`` is a key of :meth:`anim.model.Model.counts`.
    """

    def check_claim() -> ComputedResult:
        from anim.model import Model

        found = Model(ring=ring).counts()
        others = [f"{n} {kind}" for kind, n in found.items() if kind != what]
        steps = (*others, f"{found[what]} {what}")
        return ComputedResult(found[what] == count, steps, {what: [str(found[what])]})

    return Computed(f"with {ring} points on each circle the model has {count} {what}", check_claim)


def listed(names: Sequence[str], count: int, of: str) -> Computed:
    """Return the claim that a list printed in the thesis has so many entries; ``of`` describes the list."""

    def check_claim() -> ComputedResult:
        step = f"{len(names)} listed: {', '.join(names)}"
        return ComputedResult(len(names) == count, (step,), {"listed": [str(len(names))]})

    return Computed(f"{of} has {count} entries", check_claim)


def takes(name: str, count: int) -> Computed:
    """Return the claim that a function of :mod:`rotation.thesis` has so many arguments."""

    def check_claim() -> ComputedResult:
        names = list(signature(getattr(thesis, name)).parameters)
        step = f"{name}({', '.join(names)}) takes {len(names)}"
        return ComputedResult(len(names) == count, (step,), {"arguments": [str(len(names))]})

    return Computed(f"{name} takes {count} arguments", check_claim)


def film_shows(numbers: Sequence[int], frames: int = 500) -> Computed:
    """Return the claim that ten frames with these numbers are shown, out of so many frames.

    They are compared with the frames on the contact sheet (:func:`anim.output.sheet.shown`): the first frame,
    and the last frame of each tenth of the film except the last tenth.
    """

    def check_claim() -> ComputedResult:
        from anim.output.sheet import shown

        sheet = shown(frames)
        holds = list(numbers) == sheet and len(sheet) == 10 and max(sheet) < frames
        return ComputedResult(holds, (f"the sheet shows {', '.join(map(str, sheet))}",))

    text = f"the 10 frames of {frames} are {', '.join(map(str, numbers))}"
    return Computed(text, check_claim)


def loop(last: int) -> Computed:
    """Return the claim that the loop ``while time < 500`` makes the frames 0 to ``last``, 500 in all."""

    def check_claim() -> ComputedResult:
        made, time = [], 0
        while time < 500:
            made.append(time)
            time += 1
        step = f"{len(made)} frames, from {made[0]} to {made[-1]}"
        return ComputedResult(
            len(made) == 500 and made[-1] == last, (step,), {"last": [str(made[-1])]}
        )

    return Computed(f"`while time < 500` makes 500 frames, 0 to {last}", check_claim)
