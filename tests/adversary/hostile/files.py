"""Certificates made to be dear: for each kind of evidence and ring, long numbers, high degrees, many terms.

``HOSTILE`` maps a name, ``kind: what is large``, to a function of a size that makes the text of a file, and
to the sizes at which it is tried: one for tests, and one at which it is as dear as the format allows.
"""

from tests.adversary.hostile import (
    arithmetic,
    elements,
    evidence,
    identities,
    implications,
    rings,
    words,
)
from tests.adversary.hostile.writing import Hostile

HOSTILE: dict[str, Hostile] = {
    **identities.FILES,
    **implications.FILES,
    **elements.FILES,
    **rings.FILES,
    **evidence.FILES,
    **words.FILES,
    **arithmetic.FILES,
}
