import sys
from pathlib import Path

import pytest

import placecat.stages  # noqa: F401  before NumPy: it chooses the kernels of OpenBLAS

for _folder in (".", "stages"):
    sys.path.insert(0, str(Path(__file__).parent / _folder))


@pytest.fixture(scope="session")
def reproduced(tmp_path_factory):
    """The whole pipeline run once, through DVC, on small drawn homes. Tests that change it copy it."""
    from project import copy_project, repro

    folder = copy_project(tmp_path_factory.mktemp("reproduced"))
    ran, result = repro(folder)
    return folder, ran, result
