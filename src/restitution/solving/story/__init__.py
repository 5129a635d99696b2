"""The story of a problem: what is velocity, place and time of every body after every event."""
