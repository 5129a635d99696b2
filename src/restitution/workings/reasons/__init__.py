"""What is said behind a line that is no equation: *as α is acute*."""
