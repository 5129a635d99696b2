"""Expressions: numbers, letters and vectors as trees, read from text and written back."""
