"""Words, and presentations of groups with a known fundamental polygon.

A word is a tuple of ±1, ±2, …: generators and their inverses. By Poincaré's theorem the side pairings
generate the group, and the vertex cycles give all relations (Maskit, *Adv. Math.* 7, 1971). Then generators
that a relation expresses by others are eliminated (Tietze).
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence

from flint import fmpz_mat

Word = tuple[int, ...]


def freely_reduced(letters: Iterable[int]) -> Word:
    """Return a word without adjacent letters that cancel."""
    word: list[int] = []
    for letter in letters:
        if word and word[-1] == -letter:
            word.pop()
        else:
            word.append(letter)
    return tuple(word)


def cyclically_reduced(word: Word) -> Word:
    """Return a conjugate without adjacent letters that cancel, also cyclically."""
    word = freely_reduced(word)
    while len(word) > 1 and word[0] == -word[-1]:
        word = word[1:-1]
    return word


def inverse(word: Sequence[int]) -> Word:
    """Return the inverse of a word."""
    return tuple(-letter for letter in reversed(word))


def simplified(count: int, relations: list[Word]) -> tuple[list[int], list[Word], dict[int, Word]]:
    """Eliminate generators that occur exactly once in a relation.

    Return the remaining generators, the relations between them, and each generator as a word in them, all in
    the original numbering.
    """
    relations = [r for r in map(cyclically_reduced, relations) if r]
    left, put_away = list(range(1, count + 1)), list[tuple[int, Word]]()
    best: dict[Word, tuple[int, int, Word] | None] = {}
    while True:
        found = []
        for relation in relations:
            if relation not in best:
                best[relation] = shortest(relation)
            if (candidate := best[relation]) is not None:
                found.append(candidate)
        if not found:
            break
        _, n, relation = min(found)
        at = next(m for m, letter in enumerate(relation) if abs(letter) == n)
        # the relation is n^±1·rest, up to a conjugate
        rest = relation[at + 1 :] + relation[:at]
        value = inverse(rest) if relation[at] > 0 else rest
        put = {n: value, -n: inverse(value)}
        relations.remove(relation)
        changed = [
            cyclically_reduced(replaced(r, put)) if n in r or -n in r else r for r in relations
        ]
        relations = [r for r in changed if r]
        left.remove(n)
        put_away.append((n, value))
    words: dict[int, Word] = {n: (n,) for n in left}
    for n, value in reversed(put_away):  # expressed by those that were left then
        put = {letter: words[letter] if letter > 0 else inverse(words[-letter]) for letter in value}
        words[n] = freely_reduced(replaced(value, put))
    return left, relations, words


def shortest(relation: Word) -> tuple[int, int, Word] | None:
    """Return the length of the word for a generator that occurs once, the generator, and the relation; or
    None.
    """
    once = [n for n, times in Counter(map(abs, relation)).items() if times == 1]
    return (len(relation) - 1, min(once), relation) if once else None


def replaced(word: Word, values: dict[int, Word]) -> Word:
    """Substitute words for letters."""
    return tuple(x for letter in word for x in values.get(letter, (letter,)))


def abelian_invariants(count: int, relations: Sequence[Word]) -> tuple[int, ...]:
    """Return the orders of the cyclic factors of the abelianisation, each dividing the next; 0
    stands for ℤ.
    """
    rows = [[r.count(n) - r.count(-n) for n in range(1, count + 1)] for r in relations]
    if not rows or not count:
        return (0,) * count
    form = fmpz_mat(rows).snf()
    diagonal = [int(form[n, n]) if n < len(rows) else 0 for n in range(count)]
    return tuple(d for d in diagonal if d > 1) + (0,) * diagonal.count(0)
