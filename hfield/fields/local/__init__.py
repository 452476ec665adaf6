"""Local fields: completions of global fields at finite places, with elements of finite precision."""
