"""What stands before the rows of a line: titles, sentences that introduce."""
