"""The equations of a part, their unknowns, and which roots are admissible."""
