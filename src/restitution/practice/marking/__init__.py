"""Mark points, the marks that a working earns, and messages about it."""
