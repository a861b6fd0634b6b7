"""The wheel, installed in a separate environment, contains everything that the package reads and runs."""

import shutil
import sys
import sysconfig
from pathlib import Path

import pytest
from made_experiments import make_project

from project import ROOT, run

pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def installed(tmp_path_factory):
    """Return the Python and the packages folder of an environment that also uses our packages."""
    folder = tmp_path_factory.mktemp("wheel")
    source, own = folder / "source", folder / "own"
    # Copy the source, since the build writes next to it.
    shutil.copytree(ROOT / "src", source / "src", ignore=shutil.ignore_patterns("__pycache__", "*.egg-info"))
    for name in ("pyproject.toml", "README.md", "LICENSE"):
        shutil.copy(ROOT / name, source)
    pip = (sys.executable, "-m", "pip", "--disable-pip-version-check")
    run(folder, *pip, "wheel", "-q", "--no-deps", "--no-build-isolation", "-w", ".", "./source")
    run(folder, sys.executable, "-m", "venv", "--without-pip", "own")
    (wheel,) = folder.glob("*.whl")
    run(folder, *pip, "--python", own, "install", "-q", "--no-deps", "--no-compile", "--no-index", wheel)
    python = own / "bin/python"
    where = "import sysconfig; print(sysconfig.get_path('purelib'))"
    packages = Path(run(folder, python, "-c", where).stdout.strip())
    # Our packages come after those of the environment. Python ignores the .pth files among them, so it does
    # not find our editable placecat.
    (packages / "ours.pth").write_text(f"{sysconfig.get_path('purelib')}\n")
    return python, packages


def test_the_wheel_contains_every_source_file(installed):
    _, packages = installed
    ignored = ("__pycache__", ".egg-info")
    files = [
        path.relative_to(ROOT / "src").as_posix() for path in (ROOT / "src").rglob("*") if path.is_file()
    ]
    wanted = [file for file in files if not any(part in file for part in ignored)]
    assert {Path(file).suffix for file in wanted} > {".py", ".j2", ".css", ".mplstyle", ".yaml"}
    assert [file for file in wanted if not (packages / file).is_file()] == []


# If PYTHONPATH is set, it may contain the source.
WITHOUT_SOURCE = {"PYTHONPATH": ""}


def test_the_installed_package_runs_and_predicts(installed, tmp_path):
    python, packages = installed
    where = run(tmp_path, python, "-c", "import placecat; print(placecat.__file__)", **WITHOUT_SOURCE).stdout
    assert Path(where.strip()).is_relative_to(packages)
    shown = run(tmp_path, python.with_name("placecat"), "predict", "--help", **WITHOUT_SOURCE).stdout
    assert "--labels CSV" in shown


def test_a_sweep_runs(installed, tmp_path):
    python, _ = installed
    folder = make_project(tmp_path / "project")
    settings = ("descriptor=gist", "classifier=knn", "codebook.tree.branching=4", "classifier.clusters=13")
    of_sweep = ("test_home=H1", "classifier.base.n_neighbors=1,3", "track=false", "hydra/launcher=basic")
    command = (python.with_name("placecat"), "experiment", "-m", *settings, *of_sweep)
    result = run(folder, *command, "hydra.sweep.dir=swept", **WITHOUT_SOURCE)
    assert "classifier.base.n_neighbors" in result.stdout
    assert len((folder / "swept/summary.csv").read_text().splitlines()) > 2
