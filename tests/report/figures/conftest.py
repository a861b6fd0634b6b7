import pytest

from made_run import build, parameters


@pytest.fixture(scope="session")
def made_folder(tmp_path_factory):
    """The folder of a small finished run."""
    folder = tmp_path_factory.mktemp("run")
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(folder)
        build(folder, parameters())
    return folder


@pytest.fixture
def made(made_folder, monkeypatch):
    """The settings of that run; the test runs in its folder."""
    monkeypatch.chdir(made_folder)
    return parameters()
