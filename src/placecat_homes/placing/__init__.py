"""Placement of objects in a room, such that people can still walk through it."""
