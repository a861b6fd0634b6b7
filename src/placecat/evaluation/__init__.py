"""Measure accuracy, probabilities and stays, and compute the intervals on which verdicts are based."""
