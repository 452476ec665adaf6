"""Statements that are no formulas: logic between closed statements, words about a field, presentations."""
