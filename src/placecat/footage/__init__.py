"""Frames of files, with their times."""
