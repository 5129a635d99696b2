"""Marks by rule: what an examiner would give for a line."""
