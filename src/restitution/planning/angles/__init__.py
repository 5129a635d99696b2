"""Directions, and the angles between them, deflections among them."""
