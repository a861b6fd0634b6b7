"""The installer of `make`, when moved, misled by the environment, or called twice at once."""

import os
import shutil
import subprocess
import sys

import made_pipeline
import pytest

from project import ROOT, run

# A replacement for pip that records its calls.
PIP = """
import os, sys, time
from pathlib import Path
time.sleep(0.5)
with Path("pip.txt").open("a") as said:
    names = ("PIP_USER", "PIP_TARGET", "PYTHONPATH")
    settings = [f"{name}={os.environ.get(name)}" for name in names]
    said.write(" ".join([sys.prefix, *settings, *sys.argv[1:]]) + "\\n")
"""
LINES_OF_ONE = 2


@pytest.fixture
def folder(tmp_path):
    """A project to install, with a fake pip in its virtual environments."""
    folder = tmp_path / "my project"
    folder.mkdir()
    shutil.copy(ROOT / "install.py", folder)
    shutil.copy(ROOT / "Makefile", folder)
    for name in ("requirements.lock", "pyproject.toml"):
        (folder / name).write_text("")
    (folder / "venv.py").write_text(VENV)
    (folder / "made_pip.py").write_text(PIP)
    return folder


# A replacement for the module venv, which takes seconds to unpack pip.
VENV = """
import shutil
import sys
sys.path.pop(0)
import venv
from pathlib import Path
target = Path(sys.argv[-1])
venv.create(target, clear="--clear" in sys.argv, symlinks=True)
package = next(target.glob("lib/python*/site-packages")) / "pip"
package.mkdir(exist_ok=True)
shutil.copy("made_pip.py", package / "__main__.py")
configuration = target / "pyvenv.cfg"
text = "".join(line for line in configuration.read_text().splitlines(True) if not line.startswith("command"))
configuration.write_text(text + f"command = python -m venv {target.absolute()}\\n")
"""


def install(folder, **extra):
    # The folder of install.py comes first on the path, so `-m venv` runs the module above.
    command = [sys.executable, "install.py", "requirements.lock", ".venv/.installed"]
    return subprocess.Popen(command, cwd=folder, env=os.environ | extra, stderr=subprocess.PIPE, text=True)


def calls(folder):
    return (folder / "pip.txt").read_text().splitlines()


def test_it_installs_into_the_environment_despite_the_users_settings(folder):
    astray = {"PIP_USER": "1", "PIP_TARGET": "/elsewhere", "PYTHONPATH": "/elsewhere"}
    assert install(folder, **astray).wait(60) == 0
    for call in calls(folder):
        assert call.startswith(f"{folder / '.venv'} PIP_USER=0 PIP_TARGET=None PYTHONPATH=None install")
    assert (folder / ".venv/.installed").exists()


def test_a_second_call_waits_and_has_nothing_to_do(folder):
    first = install(folder)
    made_pipeline.wait_for((folder / ".venv").exists, 20)
    second = install(folder)
    assert "Another make is installing into .venv: waiting for it." in second.communicate()[1]
    assert first.communicate()[1] == ""
    assert (first.returncode, second.returncode) == (0, 0)
    assert len(calls(folder)) == LINES_OF_ONE


@pytest.mark.slow
def test_a_moved_project_is_installed_again(folder):
    assert install(folder).wait(60) == 0
    assert run(folder, "make", "-q", ".venv/.installed", check=False).returncode == 0
    moved = folder.with_name("moved")
    folder.rename(moved)
    assert run(moved, sys.executable, "install.py", "--moved").stdout == "yes\n"
    assert run(moved, "make", "-q", ".venv/.installed", check=False).returncode == 1
    assert install(moved).wait(60) == 0
    assert run(moved, sys.executable, "install.py", "--moved").stdout == "\n"
    assert [call.split(" PIP")[0] for call in calls(moved)[LINES_OF_ONE:]] == [str(moved / ".venv")] * 2
    assert run(moved, "make", "-q", ".venv/.installed", check=False).returncode == 0


def test_a_linked_environment_does_not_count_as_moved(folder):
    assert install(folder).wait(60) == 0
    linked = folder.with_name("linked")
    linked.mkdir()
    (linked / ".venv").symlink_to(folder / ".venv")
    shutil.copy(folder / "install.py", linked)
    assert run(linked, sys.executable, "install.py", "--moved").stdout == "\n"


def test_an_older_python_is_refused(folder):
    program = "import runpy, sys; sys.version_info = (3, 10, 0); sys.argv = ['install.py', 'a', 'b']; "
    program += "runpy.run_path('install.py', run_name='__main__')"
    result = run(folder, sys.executable, "-c", program, check=False)
    assert result.returncode == 1
    assert "placecat needs Python 3.11, 3.12 or 3.13" in result.stderr
    assert not (folder / ".venv").exists()
