"""What the letters and phrases of a script mean: declared, usual, or found by search."""
