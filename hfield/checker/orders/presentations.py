"""Presentations of groups: eliminate redundant generators (Tietze).

A word is a tuple of ±1, ±2, …, which stand for the generators and their inverses.
"""

from collections.abc import Iterable

from hfield.checker.budget import spend

Word = tuple[int, ...]


def simplified(left: list[int], relations: list[Word]) -> tuple[list[int], list[Word]]:
    """Eliminate generators that occur once in a relation, short relations first."""
    relations = [r for r in map(_cyclically_reduced, relations) if r]
    while True:
        spend(10 + 10 * sum(map(len, relations)))
        found = [
            (len(r) - 1, n, r)
            for r in relations
            for n in set(map(abs, r))
            if sum(abs(x) == n for x in r) == 1
        ]
        if not found:
            return left, relations
        _, n, relation = min(found)
        at = next(m for m, x in enumerate(relation) if abs(x) == n)
        rest = relation[at + 1 :] + relation[:at]  # the relation is n^±1·rest, up to a conjugate
        value = _inverse(rest) if relation[at] > 0 else rest
        put = {n: value, -n: _inverse(value)}
        relations.remove(relation)
        relations = [
            tuple(x for letter in r for x in put.get(letter, (letter,))) for r in relations
        ]
        spend(sum(map(len, relations)))
        relations = [r for r in map(_cyclically_reduced, relations) if r]
        left = [x for x in left if x != n]


def _cyclically_reduced(letters: Iterable[int]) -> Word:
    word: list[int] = []
    for x in letters:
        if word and word[-1] == -x:
            word.pop()
        else:
            word.append(x)
    first, last = 0, len(word)
    while last - first > 1 and word[first] == -word[last - 1]:
        first, last = first + 1, last - 1
    return tuple(word[first:last])


def _inverse(word: Word) -> Word:
    return tuple(-x for x in reversed(word))
