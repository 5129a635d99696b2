"""The story in doubles at many samples: the true world, random ones, the student's own."""
