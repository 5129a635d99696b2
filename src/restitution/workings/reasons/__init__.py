"""Reasons behind a line besides equations: *as α is acute*."""
