"""What a working is written with: trees, the desk, the scene of a part, checks of a line."""
