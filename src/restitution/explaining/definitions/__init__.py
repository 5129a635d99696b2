"""Definitions worked out for an event and its bodies: energies, angles, senses."""
