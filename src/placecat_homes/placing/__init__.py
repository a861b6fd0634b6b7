"""Placement of objects in a room, so that people can still walk through it."""
