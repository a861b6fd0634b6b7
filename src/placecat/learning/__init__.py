"""Codebooks and classifiers. They follow scikit-learn's conventions and never open files."""
