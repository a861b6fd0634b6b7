"""Salient regions and descriptors of a frame. This package does not use labels or open files."""
