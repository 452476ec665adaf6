"""The benchmark of the thesis (3.2) for many implementations; ``hfield bench`` runs it.

``tasks`` says what is to be computed, ``ways`` how, ``measure`` checks every way and times it,
``results``, ``chart`` show the result.
"""
