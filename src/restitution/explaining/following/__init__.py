"""The follower: whether a working can be followed, line by line."""
