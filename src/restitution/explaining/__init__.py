"""Workings as derivations: lines with premises, the moves that make them, and a follower."""
