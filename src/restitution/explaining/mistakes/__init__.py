"""Misconceptions and slips: their altered laws, and what they lead to."""
