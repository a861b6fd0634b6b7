"""Furniture for each kind of room."""
