"""The checks of evidence, one module for each kind or for a few related kinds.

``CHECKS`` of a module says what its evidence shows: by the verdict, whether the statement says "exists", and
the kind that the evidence names. :mod:`hfield.checker.evidence_registry` finds the modules by their names.
"""
