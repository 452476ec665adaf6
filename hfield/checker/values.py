"""Read the values of unknowns in a certificate."""

from hfield.checker.evaluate import Quaternion
from hfield.checker.language import Tree, parse
from hfield.checker.rejection import an_object, reject, texts
from hfield.checker.scalars.place import E
from hfield.checker.scalars.ring import AnyRing, Ring

Unknowns = tuple[tuple[str, str], ...]


def read_values(ring: Ring[E], values: object, unknowns: Unknowns) -> dict[str, E | Quaternion[E]]:
    """Read the coordinates of unknowns, for exactly those unknowns."""
    out: dict[str, E | Quaternion[E]] = {}
    for name, entries in _texts(values, unknowns).items():
        found = [ring.read(text) for text in entries]
        out[name] = Quaternion(found) if len(found) == 4 else found[0]
    return out


def trees_of_values(ring: AnyRing, values: object, unknowns: Unknowns) -> dict[str, Tree]:
    """Return the values as terms, c₀·e + c₁·i + c₂·j + c₃·k or a scalar."""
    read_values(ring, values, unknowns)
    out: dict[str, Tree] = {}
    for name, entries in _texts(values, unknowns).items():
        tree = parse(entries[0])
        if len(entries) == 4:
            parts: list[Tree] = [
                ("*", parse(c), ("name", u)) for c, u in zip(entries, "eijk", strict=True)
            ]
            tree = ("+", ("+", parts[0], parts[1]), ("+", parts[2], parts[3]))
        out[name] = tree
    return out


def _texts(values: object, unknowns: Unknowns) -> dict[str, list[str]]:
    data = an_object(values, " ".join(name for name, _ in unknowns), "the values")
    out = {name: texts(data[name], f"the values of {name}", 1) for name, _ in unknowns}
    for name, sort in unknowns:
        if len(out[name]) != (1 if sort == "s" else 4):
            reject(f"{name} has {len(out[name])} coordinates")
    return out
