"""Salient regions and descriptors of a frame, computed without labels and without opening files."""
