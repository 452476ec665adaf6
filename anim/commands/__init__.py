"""The command `hfield render`."""
