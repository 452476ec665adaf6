"""Looking for places where a claim is false: all of them in a finite ring, or a random share."""

import random
from collections.abc import Sequence
from functools import lru_cache
from typing import Any

import numpy as np

from tests.adversary.meaning import Claim, World
from tests.adversary.scalars import Exact, Modular, Places, Union
from tests.adversary.small_rings import Table

ALL = 1 << 16  # places of one ring that are all tried
Widths = tuple[tuple[str, int], ...]


@lru_cache(maxsize=64)
def union_of(tables: tuple[Table, ...]) -> Union:
    """Return the union of some rings."""
    return Union(tables)


def width(unknowns: Widths) -> int:
    """Return the number of coordinates of some unknowns."""
    return sum(n for _, n in unknowns)


def assigned(unknowns: Widths, columns: Any) -> dict[str, Any]:
    """Give unknowns their coordinates in order: one by itself, four as a tuple."""
    out, at = {}, 0
    for name, n in unknowns:
        out[name] = columns[at] if n == 1 else tuple(columns[at : at + n])
        at += n
    return out


def _every(table: Table, coordinates: int) -> np.ndarray:
    if not coordinates:
        return np.zeros((0, 1), np.int64)
    kind = np.int16 if table.order < 180 else np.int64
    return np.indices((table.order,) * coordinates, kind).reshape(coordinates, -1)


def _some(tables: Sequence[Table], where: np.ndarray, unknowns: Widths, seed: int) -> np.ndarray:
    """Return random coordinates: 0 and 1 more often, and at times unknowns that are equal."""
    rng = np.random.default_rng(seed)
    orders = np.array([t.order for t in tables])[where]
    ones = np.array([t.one for t in tables])[where]
    count = width(unknowns)
    found = (rng.random((count, len(where))) * orders).astype(np.int64)
    choice = rng.random(found.shape)
    found = np.where(choice < 0.35, 0, np.where(choice < 0.5, ones, found))
    starts = np.cumsum([0, *(n for _, n in unknowns)])
    for m, (_, wide) in enumerate(unknowns):
        for k, (_, other) in enumerate(unknowns[:m]):
            if wide == other:
                same = rng.random(len(where)) < 0.1
                for c in range(wide):
                    found[starts[m] + c] = np.where(
                        same, found[starts[k] + c], found[starts[m] + c]
                    )
    return found


def _false(
    claim: Claim, scalars: Places | Modular, given: np.ndarray, bound: np.ndarray | None = None
) -> np.ndarray:
    """Return where hypotheses hold and the conclusion does not, the algebra being defined."""
    kind = scalars.zero.dtype
    values = assigned(claim.given, given.astype(kind, copy=False))
    if bound is not None:
        values |= assigned(claim.bound, bound.astype(kind, copy=False))
    world = World(scalars, claim.constants, values)
    right = world.truth(claim.conclusion)
    for h in claim.hypotheses:
        right = right | np.logical_not(world.truth(h))
    return np.broadcast_to(world.exists & np.logical_not(right), scalars.true.shape)


def counterexample(
    claim: Claim, tables: Sequence[Table], rng: random.Random, places: int = 48
) -> str | None:
    """Return a place of one of the rings where the claim is false, None if none is found.

    A ring with few places is tried entirely; in the others ``places`` are drawn. Of a claim with
    ``exists`` only those rings are tried in which all values of the bound unknowns can be.
    """
    if claim.bound:
        return next(
            (p for t in tables if (p := _nothing_exists(claim, t, rng, places)) is not None), None
        )
    few = [t for t in tables if t.order ** width(claim.given) <= places]
    many = [t for t in tables if t.order ** width(claim.given) > places]
    rows = [_every(t, width(claim.given)) for t in few]
    where = [np.full(r.shape[1], n) for n, r in enumerate(rows)]
    drawn = np.repeat(np.arange(len(many)), places)
    if many:
        rows.append(_some(many, drawn, claim.given, rng.randrange(1 << 30)))
        where.append(drawn + len(few))
    if not rows:
        return None
    return _first(claim, union_of((*few, *many)), np.concatenate(where), np.hstack(rows))


def _first(claim: Claim, union: Union, where: np.ndarray, local: np.ndarray) -> str | None:
    scalars = Places(union, where)
    wrong = _false(claim, scalars, local + union.start[where])
    if not wrong.any():
        return None
    at = int(np.argmax(wrong))
    values = assigned(claim.given, local[:, at].tolist())
    return f"false over {union.tables[where[at]].name} at {values}"


def _nothing_exists(claim: Claim, table: Table, rng: random.Random, places: int) -> str | None:
    inner = table.order ** width(claim.bound)
    outer = table.order ** width(claim.given)
    if inner > ALL:
        return None
    most = max(1, min(places, ALL // inner))
    if outer <= most:
        given = _every(table, width(claim.given))
    else:
        given = _some([table], np.zeros(most, np.int64), claim.given, rng.randrange(1 << 30))
    return _exists_nothing_at(claim, table, given)


def _scalars(table: Table, size: int) -> Places | Modular:
    if table.order == table.characteristic:
        return Modular(table, size)
    return Places(union_of((table,)), np.zeros(size, np.int64))


def _exists_nothing_at(claim: Claim, table: Table, given: np.ndarray) -> str | None:
    bound = _every(table, width(claim.bound))
    outer, inner = given.shape[1], bound.shape[1]
    scalars = _scalars(table, outer * inner)
    spread = np.repeat(given, inner, axis=1)
    wrong = _false(claim, scalars, spread, np.tile(bound, outer))
    wrong = wrong.reshape(outer, inner).all(axis=1)
    if not wrong.any():
        return None
    return f"nothing exists over {table.name} at {given[:, int(np.argmax(wrong))].tolist()}"


def is_true(claim: Claim, table: Table, most: int = ALL) -> bool | None:
    """Tell whether a claim is true over a finite ring, by all places; None for more than ``most``."""
    if table.order ** (width(claim.given) + width(claim.bound)) > most:
        return None
    given = _every(table, width(claim.given))
    if claim.bound:
        return _exists_nothing_at(claim, table, given) is None
    return not _false(claim, _scalars(table, given.shape[1]), given).any()


def somewhere_satisfied(claim: Claim, tables: Sequence[Table], rng: random.Random) -> str | None:
    """Return a place where all hypotheses hold, None if none is found."""
    conclusion = ("!=", ("number", 0), ("number", 0))
    bare = Claim(claim.hypotheses, conclusion, claim.given, (), claim.constants)
    return counterexample(bare, tables, rng)


def is_defined(claim: Claim, tables: Sequence[Table], ring: Any, rng: random.Random) -> bool:
    """Tell whether the algebra exists somewhere: in one of the tables, or at a sample of a ring."""
    never = ("!=", ("number", 0), ("number", 0))
    bare = Claim((), never, claim.given, (), claim.constants)
    if tables and counterexample(bare, tables, rng) is not None:
        return True
    return isinstance(ring, Exact) and sampled(bare, ring, rng, 300) is not None


def true_at(claim: Claim, scalars: Any, values: dict[str, Any]) -> bool | None:
    """Tell whether a claim without ``exists``, or with values for all, is true at one place.

    None where the algebra is not defined.
    """
    world = World(scalars, claim.constants, values)
    if not np.all(world.exists):
        return None
    if not all(np.all(world.truth(h)) for h in claim.hypotheses):
        return True
    return bool(np.all(world.truth(claim.conclusion)))


def one_place(table: Table) -> Places:
    """Return scalars for a single place of a finite ring."""
    return Places(union_of((table,)), np.zeros(1, np.int64))


def sampled(
    claim: Claim, scalars: Exact, rng: random.Random, places: int = 10
) -> dict[str, Any] | None:
    """Return a place of an infinite ring where a claim without ``exists`` is false, if one is drawn."""
    if claim.bound:
        return None
    for _ in range(places):
        values: dict[str, Any] = {}
        for name, n in claim.given:
            drawn = tuple(scalars.some(rng) for _ in range(n))
            values[name] = drawn if n == 4 else drawn[0]
        alike = [n for n, w in claim.given if w == 4]
        if len(alike) > 1 and rng.random() < 0.2:
            values[alike[1]] = values[alike[0]]
        if true_at(claim, scalars, values) is False:
            return values
    return None
