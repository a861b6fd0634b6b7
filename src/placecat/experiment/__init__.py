"""Experiments with any descriptor, classifier and data on existing features, alone or as a sweep.

``placecat experiment`` is a Hydra application of conf/experiment.yaml. It uses the functions and seeds of the
tables, so the numbers are equal.
"""

# Must precede NumPy: it chooses OpenBLAS's kernels, as in the stages.
import placecat.stages  # noqa: F401
