"""Describe an algebra: collect its invariants and lay them out."""

from hfield.description.summary import SCHEMA, Description, info

__all__ = ["SCHEMA", "Description", "info"]
