"""The least and the greatest number that Python's ``random()`` can return, found by running it.

CPython's generator, the Mersenne Twister, makes a number from two 32-bit words: the upper 27 bits a of the
first and the upper 26 bits b of the second give (a·2²⁶ + b)/2⁵³, so the extreme numbers come from the extreme
words. These words are the state of the generator after an invertible linear map ("tempering"; Matsumoto and
Nishimura, 1998), so every pair of words has a state.
"""

from collections.abc import Callable
from random import Random

from hfield.ledger.claim import Computed, ComputedResult

WORDS = 624  # of the state
SAMPLES = 100
ONES = 0xFFFFFFFF


def returned(first: int, second: int) -> float:
    """Return the value of ``random()`` if the generator yields these two 32-bit words."""
    generator = Random(0)
    version, _, gauss = generator.getstate()
    words = [untempered(first), untempered(second), *[0] * (WORDS - 2)]
    generator.setstate((version, (*words, 0), gauss))  # the 0: the first word comes next
    return generator.random()


def untempered(word: int) -> int:
    """Return the state word from which the generator makes the 32-bit ``word``."""
    word ^= word >> 18
    word ^= (word << 15) & 0xEFC60000
    state = word
    for _ in range(4):  # every round settles seven more bits
        state = word ^ ((state << 7) & 0x9D2C5680)
    word = state
    for _ in range(2):  # and here eleven
        state = word ^ (state >> 11)
    return state


def is_made_of_words(seed: int) -> bool:
    """Return whether the first number for a seed is made from its first two words as described."""
    words = Random(seed)
    a, b = words.getrandbits(32) >> 5, words.getrandbits(32) >> 6
    return Random(seed).random() == (a * 2**26 + b) / 2**53


def within(interval: str, holds: Callable[[float, float], bool]) -> Computed:
    """Return the claim that all numbers of ``random()`` lie in an interval; ``holds`` checks the extremes."""

    def check_claim() -> ComputedResult:
        low, high = returned(0, 0), returned(ONES, ONES)
        return ComputedResult(
            holds(low, high) and all(map(is_made_of_words, range(SAMPLES))),
            (f"the least number is {low!r}", f"the greatest is {high!r}, {1 - high!r} below 1"),
            {"least": [repr(low)], "greatest": [repr(high)]},
        )

    return Computed(f"random() returns numbers in {interval}", check_claim)
