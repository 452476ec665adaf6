"""Integers, prime ideals, units and classes of number fields: what certificates say of them, checked."""
