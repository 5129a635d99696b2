"""Places, times and distances: where a body is, and when."""
