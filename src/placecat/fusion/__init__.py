"""Integrate the cues' distributions and smooth the result over time, which yields one decision per frame."""
