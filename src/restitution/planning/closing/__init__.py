"""The shapes in which an equation with one unknown becomes lines."""
