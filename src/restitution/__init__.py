"""Elastic collisions in two dimensions: exact answers, worked solutions."""
