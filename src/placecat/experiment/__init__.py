"""Single experiments and sweeps with any descriptor, classifier and data set, on existing features.

``placecat experiment`` is the Hydra application of conf/experiment.yaml. It uses the same functions and seeds
as the tables, so the numbers agree.
"""

# Import this before NumPy: it chooses the same OpenBLAS kernels as the stages.
import placecat.stages  # noqa: F401
