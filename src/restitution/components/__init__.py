"""The story of a problem in components: simple letters for what the textbook would call v and w.

Each impact gets a frame, along the line of centres (for a wall: perpendicular to it) and across
it, and a letter for every component that the impact changes. The principles are short equations in
these letters, and every quantity of the problem is an expression in them.
"""
