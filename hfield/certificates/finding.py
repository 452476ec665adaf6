"""What evidence shows: how far it reaches, by which methods, what it cites, which parts are vacuous."""

from collections.abc import Iterable
from dataclasses import dataclass, replace

from hfield.certificates.glossary import COMMUTATIVE_RINGS, FIELD, FIELDS

WIDTH = {FIELD: 0, FIELDS: 1, COMMUTATIVE_RINGS: 2}


@dataclass(frozen=True)
class Finding:
    """``scope``: over the field named (or as it stands), over all fields, over all commutative rings.

    ``methods`` are the names that the certificate may call its method by.
    """

    scope: str
    methods: frozenset[str]
    cites: tuple[str, ...] = ()
    vacuous: tuple[str, ...] = ()

    def within(self, scope: str) -> "Finding":
        """Return the same with no wider a scope than this."""
        return replace(self, scope=min(self.scope, scope, key=WIDTH.__getitem__))

    def also_by(self, *methods: str) -> "Finding":
        """Return the same, which these methods come to as well."""
        return replace(self, methods=self.methods | set(methods))

    def citing(self, *theorems: str) -> "Finding":
        """Return the same, citing more."""
        return replace(self, cites=tuple(dict.fromkeys((*self.cites, *theorems))))


def finding(scope: str, *methods: str) -> Finding:
    """Return what a single piece of evidence shows."""
    return Finding(scope, frozenset(methods))


def together(findings: Iterable[Finding]) -> Finding:
    """Return what several findings show that are all needed: the narrowest of their scopes."""
    every = list(findings)
    return Finding(
        min((f.scope for f in every), key=WIDTH.__getitem__, default=COMMUTATIVE_RINGS),
        frozenset().union(*(f.methods for f in every)),
        tuple(dict.fromkeys(text for f in every for text in f.cites)),
        tuple(dict.fromkeys(text for f in every for text in f.vacuous)),
    )
