"""What is to be shown, or refuted."""
