"""Codebooks and classifiers with scikit-learn's conventions. Knows nothing of files."""
