"""How many elements are of which kind, by formulas and one by one."""
