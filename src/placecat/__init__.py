"""Reproducible experiments in visual place categorization, following Bormann's thesis."""

__version__ = "0.2.0"
