"""Judge smoothing candidates on training homes, for single cues only.

Integrations cannot be judged this way: their training distributions look too good, since they come from cues
that have seen other frames of the same home.
"""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from placecat.choice.judging import Judgement, judge_home
from placecat.errors import PlacecatError
from placecat.training import fold_file
from placecat.training import plan as plans
from placecat.training.integration import apply_smoothing, fit_smoothing
from placecat.training.saved import smooth_home


def judge_smoothing(
    smoothing: Mapping[str, Any],
    source: Path,
    plan: plans.Plan,
    unseen: Mapping[str, NDArray[np.float64]],
    smallest: float,
) -> list[Judgement]:
    """Smooth the homes of a cue's fold, and judge the result.

    `smoothing` has the settings of :func:`placecat.fusion.smoothing.fit`. `source` is the fold's file from
    the stage `cues`; raises PlacecatError if it lacks cross-validated distributions. `unseen` maps each
    training home to (frames, n_classes) distributions of all its frames, from a cue that has seen neither
    this home nor the test home. A training home is smoothed with statistics of the other training homes, and
    the test home with statistics of all training homes.
    """
    if not fold_file.has(source, "cross_validated"):
        raise PlacecatError(
            f"{source} has no array cross_validated: smoothing is judged on cues with cross_validate: true; "
            "run `dvc repro`"
        )
    held_out, truth = (fold_file.read(source, name) for name in ("cross_validated", "cross_validated_truth"))
    homes = [part.home for part in plan.cues]
    home_of_frame = np.repeat(homes, [len(part.chosen()[0]) for part in plan.cues])
    judged = []
    for home in homes:
        others = [part for part in plan.cues if part.home != home]
        is_other = home_of_frame != home
        model = fit_smoothing(others, held_out[is_other], truth[is_other], smoothing)
        smoothed = apply_smoothing(model, home, unseen[home])["delayed"]
        judged.append((plan.test, home, *judge_home(home, smoothed, smallest)))
    tested = smooth_home(source, plan, smoothing)["delayed"]
    return [*judged, (plan.test, plan.test, *judge_home(plan.test, tested, smallest))]
