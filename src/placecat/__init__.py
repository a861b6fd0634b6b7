"""Reproducible experiments in visual place categorization, after Bormann's thesis."""

__version__ = "0.2.0"
