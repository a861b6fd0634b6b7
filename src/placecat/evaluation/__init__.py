"""Measures: accuracy, probabilities, stays, and intervals for verdicts."""
