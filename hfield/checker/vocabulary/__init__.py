"""Statements other than formulas: logic between closed statements, words about a field, presentations."""
