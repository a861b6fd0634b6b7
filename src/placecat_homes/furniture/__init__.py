"""Pieces of furniture, each kind in its own module."""
