"""Exact expressions as people read them: a layout as data, and text, LaTeX and MathML of it."""
