"""Integrate the cues' distributions, and smooth the result over time to decide on a place for each frame."""
