"""Results with given accuracies, for two places with equally many frames.

Each misclassified frame is assigned to the other place.
"""

import numpy as np

from placecat.results.measured import NO_SEED, Measured, Results

FRAMES = 1000
PLACES = ("bedroom", "kitchen")


def measured(percent, homes=None, *, places=PLACES):
    """Make a result from (homes,) percentages, or from (seeds, homes) if random; NaN means no frames."""
    percent = np.asarray(percent, float)
    seeds = (NO_SEED,) if percent.ndim == 1 else tuple(f"seed-{number}" for number in range(len(percent)))
    percent = np.atleast_2d(percent)
    right = np.nan_to_num(percent * FRAMES / 100).round().astype(int)
    wrong = np.where(np.isnan(percent), 0, FRAMES - right)
    confusion = np.stack([np.stack([right, wrong], -1), np.stack([wrong, right], -1)], -2)
    homes = homes or tuple(f"home_{number}" for number in range(1, percent.shape[1] + 1))
    return Measured(tuple(homes), seeds, places, confusion)


def results(missing=None, **named):
    """Make the results of a run; `named` are from `measured`."""
    homes = tuple(f"home_{number}" for number in range(1, 7))
    return Results(homes, PLACES, named, missing or {})
