"""Places of a field, as the checker knows them: finite residue fields and what elements leave there."""
