"""Questions to practise: topics, numbers that tell mistakes apart, and which comes next."""
