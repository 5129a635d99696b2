"""A solved problem put on a stage: numbers for its letters, and places and times for its events.

What a picture draws and what a motion plays is the same story, told in the same numbers.
"""
