"""Search for values at which a statement is false, or true."""
