"""Methods for existential statements."""
