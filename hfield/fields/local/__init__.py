"""Local fields: completions of global fields at finite places, elements known up to some digit."""
