"""Words, and presentations of the groups whose fundamental polygons are known.

A word is a tuple of ±1, ±2, …: generators and their inverses. By Poincaré's theorem what pairs the sides
generates, and what goes around the vertices are all relations (Maskit, *Adv. Math.* 7, 1971); then
generators that
a relation expresses by others are put away (Tietze).
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from flint import fmpz_mat

Word = tuple[int, ...]


def freely_reduced(letters: Iterable[int]) -> Word:
    """Return a word without neighbours that cancel."""
    word: list[int] = []
    for letter in letters:
        if word and word[-1] == -letter:
            word.pop()
        else:
            word.append(letter)
    return tuple(word)


def cyclically_reduced(word: Word) -> Word:
    """Return a conjugate without neighbours that cancel, the last and the first letter among them."""
    word = freely_reduced(word)
    while len(word) > 1 and word[0] == -word[-1]:
        word = word[1:-1]
    return word


def inverse(word: Sequence[int]) -> Word:
    """Return the inverse of a word."""
    return tuple(-letter for letter in reversed(word))


def simplified(count: int, relations: list[Word]) -> tuple[list[int], list[Word], dict[int, Word]]:
    """Put away generators that occur once in a relation.

    Return the generators that are left, relations between them, and every generator as a word of them; all by
    their old numbers.
    """
    relations = [r for r in map(cyclically_reduced, relations) if r]
    words: dict[int, Word] = {n: (n,) for n in range(1, count + 1)}
    left = list(range(1, count + 1))
    while True:
        found = [
            (len(relation) - 1, n, relation)
            for relation in relations
            for n in {abs(letter) for letter in relation}
            if sum(abs(letter) == n for letter in relation) == 1
        ]
        if not found:
            return left, relations, words
        _, n, relation = min(found)
        at = next(m for m, letter in enumerate(relation) if abs(letter) == n)
        # the relation is n^±1·rest, up to a conjugate
        rest = relation[at + 1 :] + relation[:at]
        value = inverse(rest) if relation[at] > 0 else rest
        put = {n: value, -n: inverse(value)}
        relations.remove(relation)
        relations = [r for r in (cyclically_reduced(replaced(r, put)) for r in relations) if r]
        words = {m: freely_reduced(replaced(w, put)) for m, w in words.items()}
        left.remove(n)


def replaced(word: Word, values: dict[int, Word]) -> Word:
    """Put words for letters."""
    return tuple(x for letter in word for x in values.get(letter, (letter,)))


def abelian_invariants(count: int, relations: Sequence[Word]) -> tuple[int, ...]:
    """Return the cyclic factors of the largest abelian quotient, each dividing the next; 0 is ℤ."""
    rows = [[r.count(n) - r.count(-n) for n in range(1, count + 1)] for r in relations]
    if not rows or not count:
        return (0,) * count
    form = fmpz_mat(rows).snf()
    diagonal = [int(form[n, n]) if n < len(rows) else 0 for n in range(count)]
    return tuple(d for d in diagonal if d > 1) + (0,) * diagonal.count(0)
