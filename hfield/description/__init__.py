"""Describe an algebra: all that is known of it."""

from hfield.description.summary import SCHEMA, Description, info

__all__ = ["SCHEMA", "Description", "info"]
