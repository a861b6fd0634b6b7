"""What dvc.lock knows of the data of a run."""

from pathlib import Path

import yaml

from placecat.errors import PlacecatError

LOCK = Path("dvc.lock")


def data_version(stage: str = "sequences") -> str:
    """DVC's checksum of the frames that a stage listed, of which each has the checksum of its source file.

    Parameters
    ----------
    stage
        ``sequences``, or ``site_sequences@NAME`` for a further data set.

    Raises
    ------
    PlacecatError
        If that stage has not run through DVC.
    """
    try:
        lock = yaml.safe_load(LOCK.read_text(encoding="utf-8"))
        return str(lock["stages"][stage]["outs"][0]["md5"])
    except (FileNotFoundError, KeyError, TypeError):
        raise PlacecatError(f"{LOCK} has no stage {stage}: run `dvc repro` to make it") from None
