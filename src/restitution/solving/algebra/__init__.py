"""Exact algebra: polynomials, numbers, roots, and what is printed of them."""
