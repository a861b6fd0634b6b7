"""Pieces of furniture, one module per kind."""
