"""Experiments: any descriptor, classifier and data on the features that are there, one or a sweep of them.

``placecat experiment`` is a Hydra application of conf/experiment.yaml. An experiment computes what a cell of
a table does, by the same functions and with the same seeds, so that the numbers are the same.
"""

# Before NumPy: it chooses the kernels of OpenBLAS, as the stages do.
import placecat.stages  # noqa: F401
