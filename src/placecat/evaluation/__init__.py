"""Measure the quality of decisions and probabilities, compute intervals, and judge claims."""
