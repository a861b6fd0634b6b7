import sys
from pathlib import Path

import pytest

# Make made_experiments importable.
sys.path.insert(0, str(Path(__file__).parent))


@pytest.fixture(scope="session")
def made_project(tmp_path_factory):
    """A project shared by all tests. A test that changes its project makes a separate one."""
    from made_experiments import make_project

    return make_project(tmp_path_factory.mktemp("experiment") / "made")


@pytest.fixture
def project(made_project, monkeypatch):
    """The generated project as the working directory."""
    monkeypatch.chdir(made_project)
    return made_project
