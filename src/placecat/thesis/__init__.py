"""Compare a run with the thesis: its tables, its findings, and the numbers in its text."""
