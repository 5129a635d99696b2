"""How a working calls what it speaks of, and what its values look like."""
