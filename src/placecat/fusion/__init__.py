"""Integration and smoothing, which turn the cues' distributions into one decision."""
