"""What leaves the package for other programs: solutions as JSON, answers without their working."""
