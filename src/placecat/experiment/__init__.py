"""Experiments: any descriptor, classifier and data on existing features, single or as a sweep.

``placecat experiment`` is a Hydra application of conf/experiment.yaml. It uses the functions and seeds of the
tables, so the numbers are equal.
"""

# Before NumPy: chooses OpenBLAS's kernels, as the stages do.
import placecat.stages  # noqa: F401
