"""What a certificate must be about, if whoever checks it says so."""

from dataclasses import dataclass

from hfield.certificates.rejection import reject, shown
from hfield.certificates.scalars.fields import read_field
from hfield.certificates.statement import read_setting
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
        if read_setting(asked, field).constants != read_setting(algebra, field).constants:
            reject(f"this is about the algebra {shown(algebra)}")
