"""All that is known of an algebra at once, and the page about it."""

from hfield.description.asking import SCHEMA, Description, info

__all__ = ["SCHEMA", "Description", "info"]
