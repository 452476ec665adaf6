"""The benchmark of the thesis (3.2) for many implementations; ``hfield bench`` runs it.

``tasks`` has the computations and ``ways`` the implementations. ``measure`` checks and times each
implementation; ``results`` and ``chart`` show the times.
"""
