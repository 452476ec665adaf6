"""The base class of claims that count functions of a program, and do not concern a field."""

from hfield.ledger.claim import Computed, ComputedResult
from rotation import thesis


def listed(names: tuple[str, ...], count: int) -> Computed:
    """Return the claim that so many functions are listed and that each of them exists."""

    def check_claim() -> ComputedResult:
        missing = [name for name in names if not callable(getattr(thesis, name, None))]
        return ComputedResult(
            len(set(names)) == count and not missing,
            (f"listed: {', '.join(names)}", f"{len(set(names))} names, {count} announced"),
        )

    return Computed(f"{count} functions are listed, and all exist: {', '.join(names)}", check_claim)
