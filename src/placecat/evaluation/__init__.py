"""Measures of accuracy, probabilities and stays, and intervals for verdicts."""
