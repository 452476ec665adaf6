"""Evaluate statements at values of their unknowns."""
