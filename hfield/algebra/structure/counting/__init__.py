"""Count the elements with a property, by formulas and one by one."""
