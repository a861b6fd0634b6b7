"""One module a DVC stage, of the same name: files in, files out, no mathematics."""

import argparse
import logging
import os
import sys
from collections.abc import Callable

from placecat.errors import PlacecatError


def run(stage: Callable[..., None], *, item: str | None = None) -> None:
    """Run a stage from the command line: ``python -m placecat.stages.NAME [ITEM]``.

    A mistake of the user's ends with its message and status 1, without a traceback.

    Parameters
    ----------
    stage
        Takes the item, if the stage has one.
    item
        What the item is, for ``--help``, e.g. "home".
    """
    parser = argparse.ArgumentParser(description=(stage.__doc__ or "").splitlines()[0])
    if item is not None:
        parser.add_argument(item)
    arguments = parser.parse_args()
    logging.basicConfig(level=logging.WARNING, format="%(levelname)s %(message)s")
    os.environ.setdefault("MLFLOW_DISABLE_TELEMETRY", "true")
    try:
        stage(*vars(arguments).values())
    except PlacecatError as error:
        sys.exit(f"placecat: {error}")
    except KeyboardInterrupt:
        sys.exit(130)
