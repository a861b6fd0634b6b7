"""Walks through a building: the order of rooms, the path, and where the camera looks."""
