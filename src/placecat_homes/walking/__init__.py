"""Walks through a building: in which order, along which path, looking where."""
