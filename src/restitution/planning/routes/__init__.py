"""From the goal of an item to its lines: which equations, in which order, and the last lines."""
