"""Candidates for the delay of the smoothing, judged on training homes from what the stages left.

``python -m placecat.smoothing_choice`` prints them for the cues of ``smoothing.cues``. Systems are left out:
the distributions that train their integration come from cues that have seen other frames of the same home,
and so look better than they are.
"""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import pandas as pd

from placecat import files, listing, paths, settings
from placecat.errors import PlacecatError
from placecat.evaluation import protocol
from placecat.evaluation.smoothing_candidates import TrainingHome, smoothing_candidates

DELAYS = (0.0, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0)
"""Time constants in seconds."""


def candidates(
    params: Mapping[str, Any],
    cue: str,
    scheme: str,
    *,
    setting: str = "delay_seconds",
    values: Sequence[Any] = DELAYS,
) -> pd.DataFrame:
    """Judge values of a setting of the smoothing in every fold of one cue.

    Parameters
    ----------
    params
        All settings.
    cue, scheme
        A cue, and one of its schemes.
    setting, values
        As for :func:`placecat.evaluation.smoothing_candidates.smoothing_candidates`.

    Returns
    -------
    pandas.DataFrame
        As that function's, of all test homes; means over seeds.

    Raises
    ------
    PlacecatError
        If the cue was not cross-validated by home.
    """
    source = paths.CUES / cue / scheme
    selection = settings.get(params, "protocol.cue_frames")
    smoothing = {key: value for key, value in params["smoothing"].items() if key not in ("cues", "filtered")}
    tables = []
    homes = list(settings.get(params, "dataset.homes"))
    for fold in protocol.folds(homes, scheme, settings.get(params, "protocol.test_homes")):
        for seed in listing.seeds_in(source / fold.test):
            table = smoothing_candidates(
                _training_homes(source / fold.test / seed, fold.cue_homes, selection),
                len(settings.get(params, "dataset.classes")),
                test_home=fold.test,
                setting=setting,
                values=values,
                smoothing=smoothing,
                smallest=settings.get(params, "probabilities.smallest"),
            )
            tables.append(table)
    keys = ["setting", "value", "test_home", "training_home"]
    return pd.concat(tables).groupby(keys, sort=False).mean().reset_index()


def _training_homes(
    folder: Path, homes: Sequence[str], selection: Mapping[str, int]
) -> dict[str, TrainingHome]:
    path = folder / "cross_validated.npy"
    if not path.exists():
        raise PlacecatError(
            f"{path} is missing: the smoothing is judged on results that are cross-validated, such as nu_svm"
        )
    proba, start, found = files.read_array(path, memory_map=False), 0, {}
    for home in homes:
        labels = listing.read_labels(home)
        rows = protocol.select_frames(labels, **selection)
        found[home] = TrainingHome(
            labels=labels,
            sequences=listing.sequence_slices(home),
            frame_rate=listing.frame_rate(home),
            rows=rows,
            step=selection["step"],
            proba=proba[start : start + len(rows)],
        )
        start += len(rows)
    return found


def main() -> None:
    """Print the means over homes of each cue."""
    params = settings.load()
    for cue in settings.get(params, "smoothing.cues"):
        scheme = settings.get(params, f"cues.{cue}.schemes")[0]
        means = candidates(params, cue, scheme).groupby("value")[["accuracy", "log_loss"]].mean()
        print(f"{cue}, {scheme}\n{means.round(3).to_string()}\n")


if __name__ == "__main__":
    main()
