"""What the rows about programs have in common: they are about no field, and count functions."""

from hfield.ledger.claim import CheckResult, Computed
from rotation import thesis


def listed(names: tuple[str, ...], count: int) -> Computed:
    """Say that so many functions are listed, and that each of them exists."""

    def check_claim() -> CheckResult:
        missing = [name for name in names if not callable(getattr(thesis, name, None))]
        return CheckResult(
            len(set(names)) == count and not missing,
            (f"listed: {', '.join(names)}", f"{len(set(names))} names, {count} announced"),
        )

    return Computed(f"{count} functions are listed, and all exist: {', '.join(names)}", check_claim)
