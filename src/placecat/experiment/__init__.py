"""Run single experiments and sweeps on existing features, with any descriptor, classifier and data set.

``placecat experiment`` is the Hydra application configured by conf/experiment.yaml. It uses the same
functions and seeds as the tables, so the numbers agree.
"""

# Import this before NumPy: it chooses the same OpenBLAS kernels as the stages.
import placecat.stages  # noqa: F401
