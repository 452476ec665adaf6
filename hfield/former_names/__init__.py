"""Modules by their names in earlier versions, for pickles that name them.

This folder is on the path of the package :mod:`hfield`, so that its modules are imported as ``hfield.rings``,
``hfield.quaternion`` and ``hfield.element_text``.
"""
