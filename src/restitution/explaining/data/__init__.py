"""What a statement gives: facts with ids, where bodies and walls are, what is plain of them."""
