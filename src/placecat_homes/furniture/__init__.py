"""Pieces of furniture, one kind a module."""
