"""Statements evaluated at values: over any scalars, many at a time, in all cases of a finite ring."""
