"""Who asks whom among the modules about lattices: functions stand below the objects that offer them."""

from tests.test_layers import graph, sources

ROOM = "hfield.lattices."
OBJECTS = {ROOM + name for name in ("lattice", "order", "one_sided_ideals", "ideal")}
"""They make one another: a lattice its left order, an order its ideals, an ideal its order."""


def reached(imports: dict[str, set[str]], start: str) -> set[str]:
    done: set[str] = set()
    todo = list(imports[start])
    while todo:
        module = todo.pop()
        if module not in done:
            done.add(module)
            todo += imports[module]
    return done


def test_only_the_objects_ask_each_other() -> None:
    imports = graph([s for s in sources() if s[0].startswith(ROOM)], set())
    assert {m for m in imports if m in reached(imports, m)} == OBJECTS
