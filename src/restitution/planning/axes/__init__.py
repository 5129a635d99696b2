"""Lines of centres and walls whose direction is worked out."""
