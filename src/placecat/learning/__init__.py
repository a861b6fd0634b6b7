"""Codebooks and classifiers with scikit-learn's conventions. This package opens no files."""
