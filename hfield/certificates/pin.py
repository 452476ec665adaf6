"""What a certificate must be about, if whoever checks it says so."""

from collections.abc import Mapping
from dataclasses import dataclass

from hfield.certificates.kinds import prove
from hfield.certificates.language import Tree
from hfield.certificates.rejection import Rejected, reject, shown
from hfield.certificates.scalars.fields import read_ring
from hfield.certificates.statement import QUATERNIONS, SCALARS, Setting, read_setting
from hfield.certificates.vocabulary.logic import meaning


@dataclass(frozen=True)
class Pin:
    """What a certificate has to be about. ``field`` None is all fields; ``any_field`` any at all.

    Statements are compared as trees, algebras as constants; ``statements`` are alternatives. ``field`` is a
    canonical name or the data of a ring. No unknown may mean an element of the field; but where that is
    named and the statement is no ``claim``, which is of no field, its generators win over scalar unknowns.
    """

    statements: tuple[str, ...]
    field: str | Mapping[str, object] | None = None
    algebra: str | None = None
    any_field: bool = False
    claim: bool = False

    def readable(self) -> "Pin":
        """Return the pin itself. Raises :class:`Rejected` for a statement that cannot be read."""
        for statement in self.statements:
            meaning(statement)
        return self

    def check(self, statement: str, setting: Setting) -> None:
        """Reject a certificate about anything else."""
        said, ring = meaning(statement), setting.field
        if not any(said == meaning(s) for s in self.statements):
            reject(f"this is about another statement: {shown(statement, 120)}")
        here = None if ring is None else ring.name
        wanted = read_ring(self.field).name if isinstance(self.field, Mapping) else self.field
        if not self.any_field and here != wanted:
            reject(f"this is about {here or 'all fields'}, not about {wanted or 'all fields'}")
        letters = {*QUATERNIONS, *(SCALARS if self.claim or self.any_field else "")}
        for name in sorted(_unknowns(said) & letters):
            if ring is not None and ring.constant(("name", name)) is not None:
                reject(f"{name} is an unknown of the statement, and an element of {shown(here)}")
        asked = self.algebra or f"(-1,-1|{here or 'F'})"
        if not same_algebra(read_setting(asked, ring), setting):
            reject(f"this is about the algebra {shown(setting.algebra)}")


def _unknowns(tree: Tree) -> set[str]:
    """Return the letters in a tree that are unknowns where no field is named."""
    if len(tree) == 2 and tree[0] == "name":
        return {tree[1]} & {*QUATERNIONS, *SCALARS}
    return {name for part in tree if isinstance(part, tuple) for name in _unknowns(part)}


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
