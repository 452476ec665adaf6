"""The result of a decision procedure: a verdict with its evidence."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from hfield.checker import glossary
from hfield.checker.glossary import (
    CERTIFIED,
    NONE,
    NOT_APPLICABLE,
    PROVED,
    REFUTED,
    UNDECIDED,
    VACUOUS,
    VERDICTS,
)
from hfield.errors import UndecidedError
from hfield.evidence import Evidence, Kind, certificate
from hfield.fields.base.ring import Ring
from hfield.fields.names import ring

# The verdicts and scopes, which those who decide take from here.
__all__ = [
    "COMMUTATIVE_RINGS",
    "FIELD",
    "FIELDS",
    "NOT_APPLICABLE",
    "ORDERED_FIELDS",
    "PROVED",
    "REDUCED_RINGS",
    "REFUTED",
    "UNDECIDED",
    "VACUOUS",
    "VERDICTS",
    "Decision",
    "Scope",
]


class Scope(str):
    """The scope of a verdict in words; ``primes`` are the primes of "characteristics [...]"."""

    primes: tuple[int, ...] = ()

    @classmethod
    def characteristics(cls, primes: Iterable[int]) -> "Scope":
        """Return the scope of a statement that holds exactly over the rings of these characteristics."""
        listed = sorted(primes)
        scope = cls(f"characteristics {listed}")
        scope.primes = tuple(listed)
        return scope


FIELD, FIELDS = Scope(glossary.FIELD), Scope(glossary.FIELDS)
ORDERED_FIELDS = Scope(glossary.ORDERED_FIELDS)
REDUCED_RINGS = Scope(glossary.REDUCED_RINGS)
COMMUTATIVE_RINGS = Scope(glossary.COMMUTATIVE_RINGS)


@dataclass(frozen=True)
class Decision:
    """A verdict and how it was reached. It is plain data, so it can be pickled and written as JSON.

    ``verdict`` is one of :data:`VERDICTS`. ``method`` names the procedure in the words of
    :mod:`hfield.checker.glossary`. ``witness`` maps each unknown to the texts of its coordinates (four, or
    one for a scalar), which the field can read; if no field was named, the key ``F`` holds the field of the
    witness. ``steps`` are the lines of the proof. ``scope`` says where the statement was proved:
    ``commutative rings``, ``reduced rings``, ``fields``, ``ordered fields``, ``characteristics [..]`` or
    ``field``. ``assumes`` lists theorems that are cited and not checked, and ``tried`` the methods tried on
    an undecided statement. ``evidence`` is the data with which a program checks the verdict.
    """

    verdict: str
    method: str
    witness: Mapping[str, list[str]] | None = None
    steps: tuple[str, ...] = ()
    scope: Scope | None = None
    assumes: tuple[str, ...] = ()
    tried: tuple[str, ...] = ()
    evidence: Evidence | None = None

    def __post_init__(self) -> None:
        if self.verdict not in VERDICTS:
            raise ValueError(f"{self.verdict!r} is not a verdict; expected one of {VERDICTS}")
        if self.scope is not None and not isinstance(self.scope, Scope):  # a word of anyone's claim
            object.__setattr__(self, "scope", Scope(self.scope))

    def certificate(
        self, statement: str, algebra: str, field: Ring | None
    ) -> dict[str, object] | None:
        """Return the decision as an unchecked certificate ``hfield-cert/2``; None without verdict or
        evidence.

        There is also none over a ring without a data format, such as a user-defined ring.
        """
        data, name = (None, None) if field is None else (field.data, field.name)
        if field is not None and data is None:
            return None
        if self.evidence is None or self.verdict not in CERTIFIED:
            return None
        from hfield.checker.vocabulary.logic import names_of_rings

        evidence, named = self.evidence, [ring(n).data for n in names_of_rings(statement)]
        if named:
            evidence = Evidence(Kind.RINGS, rings=named, evidence=evidence)
        judged = (self.verdict, self.method, self.assumes, evidence)
        return certificate(statement, algebra, name, data, *judged)

    def __bool__(self) -> bool:
        """True for proved or vacuous, False for refuted. Raises UndecidedError otherwise."""
        if self.verdict in (PROVED, VACUOUS):
            return True
        if self.verdict == REFUTED:
            return False
        tried = "; ".join(self.tried) or self.method
        raise UndecidedError(f"this is {self.verdict}, so it is neither true nor false: {tried}")


def undecided(*tried: str, method: str = NONE) -> Decision:
    """Return the verdict undecided, with the methods that were tried."""
    return Decision(UNDECIDED, method, tried=tried)
