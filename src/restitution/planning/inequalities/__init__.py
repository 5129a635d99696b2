"""Conditions, ranges and extrema: how an inequality is worked out."""
