"""Comparison of a run with the thesis: tables, findings, numbers in the text."""
