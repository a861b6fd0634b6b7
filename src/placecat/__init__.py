"""Reproducible experiments in visual place categorization, after Bormann's thesis of that name."""

__version__ = "0.2.0"
