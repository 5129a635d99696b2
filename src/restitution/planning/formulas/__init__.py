"""Velocities, impulses, energies and angles by their definitions, and the laws of an impact."""
