"""Check a search's requirements before computing anything."""

import importlib.util
from collections.abc import Mapping
from typing import Any

from placecat.errors import PlacecatError

JUDGE = "training_homes"


def check(config: Mapping[str, Any]) -> None:
    """Refuse a search whose result would be meaningless.

    Raises PlacecatError if Optuna is not installed, if ``judge`` is not ``training_homes``, or unless there
    is exactly one test home.
    """
    need_optuna()
    if config.get("judge") != JUDGE:
        raise PlacecatError(
            f"judge={config.get('judge')}: a search is judged on training homes only, since a setting "
            f"chosen by its accuracy on the test home says nothing about new homes; use judge={JUDGE}"
        )
    home = config.get("test_home")
    several = not isinstance(home, str) and (home is None or len(home) != 1)
    if home == "all" or several:
        raise PlacecatError(
            f"test_home={home}: a search leaves out one test home, since a setting chosen on all folds has "
            "seen every home; name one, e.g. test_home=home_1, and search once for each"
        )


def need_optuna() -> None:
    """Raise PlacecatError if Optuna is not installed."""
    if importlib.util.find_spec("optuna") is None:
        raise PlacecatError("a search needs Optuna: install it with `pip install -e .[search]`")
