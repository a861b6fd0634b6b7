"""Codebooks and classifiers that follow scikit-learn's conventions. This package does not open files."""
