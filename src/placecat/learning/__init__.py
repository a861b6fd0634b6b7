"""Codebooks and classifiers that follow scikit-learn's conventions and never open files."""
