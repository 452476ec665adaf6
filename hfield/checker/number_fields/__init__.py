"""Check certificates about integers, prime ideals, units and class groups of number fields."""
