"""What a certificate must be about, if whoever checks it says so."""

from dataclasses import dataclass

from hfield.certificates.kinds import prove
from hfield.certificates.rejection import Rejected, reject, shown
from hfield.certificates.scalars.fields import read_field
from hfield.certificates.statement import Setting, read_setting
from hfield.certificates.vocabulary.logic import meaning


@dataclass(frozen=True)
class Pin:
    """What a certificate has to be about. ``field`` None is all fields; ``any_field`` any at all.

    Statements are compared as trees, algebras as constants; ``statements`` are alternatives.
    """

    statements: tuple[str, ...]
    field: str | None = None
    algebra: str | None = None
    any_field: bool = False

    def readable(self) -> "Pin":
        """Return the pin itself. Raises :class:`Rejected` for a statement that cannot be read."""
        for statement in self.statements:
            meaning(statement)
        return self

    def check(self, statement: str, algebra: str, field: str | None) -> None:
        """Reject a certificate about anything else."""
        if not any(meaning(statement) == meaning(s) for s in self.statements):
            reject(f"this is about another statement: {shown(statement, 120)}")
        if not self.any_field:
            here = None if field is None else read_field(field).name
            wanted = None if self.field is None else read_field(self.field).name
            if here != wanted:
                reject(f"this is about {here or 'all fields'}, not about {wanted or 'all fields'}")
        asked = self.algebra or f"(-1,-1|{'F' if field is None else field})"
        if not same_algebra(read_setting(asked, field), read_setting(algebra, field)):
            reject(f"this is about the algebra {shown(algebra)}")


def same_algebra(one: Setting, other: Setting) -> bool:
    """Tell whether the structure constants are equal wherever those of one of the two are defined."""
    if one.constants == other.constants:
        return True
    if set(one.letters) != set(other.letters):
        return False
    try:
        for setting in (one, other):
            for u, v in zip(one.constants, other.constants, strict=True):
                prove(("==", u, v), setting, {"kind": "identity"})
    except Rejected:
        return False
    return True
