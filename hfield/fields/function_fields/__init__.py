"""Rational function fields k(t): Hilbert symbols, residue fields, conics, common slots, inseparable
extensions.
"""
