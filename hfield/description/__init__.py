"""All that is known of an algebra at once, and the page about it."""

from hfield.description.summary import SCHEMA, Description, info

__all__ = ["SCHEMA", "Description", "info"]
