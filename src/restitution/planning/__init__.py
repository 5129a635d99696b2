"""Workings are planned: Solution → Derivation."""
