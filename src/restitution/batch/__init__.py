"""Many impacts or many cases at once: arrays, compiled code, all processors."""
