"""Walks through a building, with the order of the rooms, the path, and where the camera looks."""
