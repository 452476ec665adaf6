"""Methods that prove quantifier-free statements, over one ring and over all fields."""
