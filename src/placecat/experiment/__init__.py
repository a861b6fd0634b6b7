"""Experiments with any descriptor, classifier and data, run on existing features, singly or in sweeps.

``placecat experiment`` is the Hydra application of conf/experiment.yaml. It uses the same functions and seeds
as the tables, so it gives the same numbers.
"""

# Must be imported before NumPy, because it chooses OpenBLAS's kernels as the stages do.
import placecat.stages  # noqa: F401
