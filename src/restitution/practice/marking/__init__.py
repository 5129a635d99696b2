"""Mark points, the marks that a working earns, and what is said of it."""
