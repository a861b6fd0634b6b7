"""Experiments: any descriptor, classifier and data on existing features, single or as a sweep.

``placecat experiment`` is a Hydra application of conf/experiment.yaml. An experiment computes the same as a
table's cell, by the same functions and with the same seeds, so the numbers are equal.
"""

# Before NumPy: chooses OpenBLAS's kernels, as the stages do.
import placecat.stages  # noqa: F401
