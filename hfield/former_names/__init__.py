"""Modules under their names in earlier versions, for pickles that refer to them.

This folder is on the path of the package :mod:`hfield`, so its modules can be imported as ``hfield.rings``,
``hfield.quaternion`` and ``hfield.element_text``.
"""
