"""Salient regions and descriptors of a frame, computed without labels or file access."""
