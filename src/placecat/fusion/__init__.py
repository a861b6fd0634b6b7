"""Integrate the distributions of the cues, and smooth the result over time to decide on a place per frame."""
