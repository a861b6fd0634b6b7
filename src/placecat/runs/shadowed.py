"""Reject packages on PYTHONPATH that hide installed ones, since other versions produce different numbers."""

import importlib.machinery
import os
import sysconfig
from pathlib import Path

from placecat.errors import PlacecatError

PACKAGES = ("cv2", "numpy", "scipy", "sklearn", "pandas", "joblib", "matplotlib", "mlflow", "dvc", "yaml")


def check() -> None:
    """Raise PlacecatError if a package on PYTHONPATH hides an installed one; the message names its path."""
    installed = [str(Path(sysconfig.get_path(kind)).resolve()) for kind in ("purelib", "platlib")]
    folders = [folder for folder in os.environ.get("PYTHONPATH", "").split(os.pathsep) if folder]
    folders = [folder for folder in folders if str(Path(folder).resolve()) not in installed]
    if not folders:
        return
    find = importlib.machinery.PathFinder.find_spec
    for name in PACKAGES:
        other = find(name, folders)
        # A folder without code is not a package.
        if other is not None and other.origin is not None and find(name, installed) is not None:
            raise PlacecatError(
                f"PYTHONPATH hides the installed {name} behind {other.origin}: unset PYTHONPATH"
            )
