"""A solved problem as pictures to scale: scenes of shapes as data, and SVG made of them."""
