"""Who asks whom among the modules about lattices: functions stand below the objects that offer them."""

from tests.test_layers import imports, sources

ROOM = "hfield.lattices."
OBJECTS = {"lattice", "order", "one_sided_ideals", "ideal"}
"""They make one another: a lattice its left order, an order its ideals, an ideal its order."""


def at_run_time(source: str) -> str:
    """A source without the imports that only serve annotations."""
    head, _, tail = source.partition("if TYPE_CHECKING:\n")
    while tail.startswith((" ", "\n")):
        tail = tail.partition("\n")[2]
    return head + tail


def asked() -> dict[str, set[str]]:
    """For each module those of the room that it imports, also inside functions."""
    found = {m.removeprefix(ROOM): s for m, s in sources() if m.startswith(ROOM)}
    return {
        module: {
            name for name in found for t in imports(at_run_time(s), module) if t == ROOM + name
        }
        for module, s in found.items()
    }


def reached(graph: dict[str, set[str]], start: str) -> set[str]:
    done: set[str] = set()
    todo = list(graph[start])
    while todo:
        module = todo.pop()
        if module not in done:
            done.add(module)
            todo += graph[module]
    return done


def test_only_the_objects_ask_each_other() -> None:
    graph = asked()
    assert {m for m in graph if m in reached(graph, m)} == OBJECTS
