"""Verdicts on lines, and the names of the mistakes that begin there."""
