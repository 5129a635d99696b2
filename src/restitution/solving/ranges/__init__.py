"""All values that something can take: ranges, extrema, and for which letters an answer holds."""
