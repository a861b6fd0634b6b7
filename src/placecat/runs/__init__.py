"""Runs that are killed, started twice, or whose settings change: what keeps the results right."""
