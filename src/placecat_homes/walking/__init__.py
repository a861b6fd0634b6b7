"""Walks through a building: the order of the rooms, the path, and the gaze of the camera."""
