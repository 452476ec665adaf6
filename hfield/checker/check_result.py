"""The result of checking evidence: its scope, its method, and the theorems that it cites."""

from collections.abc import Iterable
from dataclasses import dataclass, replace

from hfield.checker.glossary import COMMUTATIVE_RINGS, FIELD, FIELDS, ORDERED_FIELDS
from hfield.checker.scalars.ring import AnyRing

WIDTH = {FIELD: 0, ORDERED_FIELDS: 1, FIELDS: 2, COMMUTATIVE_RINGS: 3}


@dataclass(frozen=True)
class CheckResult:
    """The scope is the named field (or the statement as it stands), all fields, or all commutative rings.

    ``method`` is the name that the certificate must give; each kind of proof has one name. ``left_out`` lists
    parts of a statement that were not checked because the verdict does not depend on them; ``rings`` are the
    rings that its words name.
    """

    scope: str
    method: str
    cites: tuple[str, ...] = ()
    vacuous: tuple[str, ...] = ()
    left_out: tuple[str, ...] = ()
    rings: tuple[AnyRing, ...] = ()

    def within(self, scope: str) -> "CheckResult":
        """Return the result with the scope restricted to ``scope``."""
        return replace(self, scope=min(self.scope, scope, key=WIDTH.__getitem__))

    def by(self, method: str) -> "CheckResult":
        """Return the result with another method name."""
        return replace(self, method=method)

    def citing(self, *theorems: str) -> "CheckResult":
        """Return the result with further citations."""
        return replace(self, cites=tuple(dict.fromkeys((*self.cites, *theorems))))

    def without(self, *texts: str) -> "CheckResult":
        """Return the result with further exceptions."""
        return replace(self, left_out=tuple(dict.fromkeys((*self.left_out, *texts))))


def together(findings: Iterable[CheckResult]) -> CheckResult:
    """Return the combined result of several checks: the narrowest scope, and each method once."""
    every = list(findings)
    return CheckResult(
        min((f.scope for f in every), key=WIDTH.__getitem__, default=COMMUTATIVE_RINGS),
        "; ".join(dict.fromkeys(f.method for f in every)),
        tuple(dict.fromkeys(text for f in every for text in f.cites)),
        tuple(dict.fromkeys(text for f in every for text in f.vacuous)),
        tuple(dict.fromkeys(text for f in every for text in f.left_out)),
    )
