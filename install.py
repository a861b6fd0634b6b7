"""Install this project and the packages in a lock file into .venv: ``python install.py LOCK_FILE MARKER``.

`make` runs this script, which needs only the standard library. ``python install.py --moved`` prints "yes" if
.venv is broken because it was moved with the project or its Python no longer exists.
"""

import os
import re
import subprocess
import sys
from pathlib import Path

VENV = Path(".venv")
# Variables that would make pip install packages outside .venv, or Python load packages from elsewhere.
FOREIGN = ("PIP_CONSTRAINT", "PIP_PREFIX", "PIP_ROOT", "PIP_TARGET", "PYTHONHOME", "PYTHONPATH")


def main(lock: str, marker: Path) -> None:
    """Install everything, unless another `make` has just done so; wait while another `make` is installing."""
    if not (3, 11) <= sys.version_info[:2] < (3, 14):
        sys.exit("placecat needs Python 3.11, 3.12 or 3.13; choose one, e.g. make PYTHON=python3.12 ...")
    with Path(".venv.lock").open("w") as held:
        _wait_for(held)
        is_moved = moved()
        if not is_moved and _is_newer(marker, (lock, "pyproject.toml")):
            return
        environment = {name: value for name, value in os.environ.items() if name not in FOREIGN}
        # pip's configuration files can set this as well, but environment variables override them.
        environment |= {"PIP_USER": "0", "PYTHONNOUSERSITE": "1"}

        def run(*command: object) -> None:
            status = subprocess.run([str(part) for part in command], env=environment, check=False).returncode
            if status:
                sys.exit(status)

        run(sys.executable, "-m", "venv", *(["--clear"] if is_moved else []), VENV)
        # With these options, pip shows errors, but no notices about its own version.
        pip = (VENV / "bin/python", "-m", "pip", "install", "-qq", "--disable-pip-version-check")
        print(f"Installing the packages in {lock} into {VENV}; takes minutes the first time.", flush=True)
        run(*pip, "--require-hashes", "-r", lock)
        run(*pip, "--no-deps", "--no-build-isolation", "-e", ".")
        marker.touch()


def moved() -> bool:
    """Check whether .venv exists but is broken, because it was moved or its Python no longer exists."""
    try:
        settings = (VENV / "pyvenv.cfg").read_text(encoding="utf-8")
    except OSError:
        return False
    made_at = re.search(r"^command = .* -m venv (?:--\S+ )*(.+)$", settings, re.MULTILINE)
    if made_at and not (Path(made_at[1]).exists() and Path(made_at[1]).samefile(VENV)):
        return True
    return not (VENV / "bin/python").exists()


def _wait_for(held: object) -> None:
    try:
        import fcntl
    except ImportError:
        return
    try:
        fcntl.flock(held, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        print("Another make is installing into .venv: waiting for it.", file=sys.stderr, flush=True)
        fcntl.flock(held, fcntl.LOCK_EX)


def _is_newer(marker: Path, sources: tuple) -> bool:
    return marker.exists() and all(
        Path(source).stat().st_mtime <= marker.stat().st_mtime for source in sources
    )


if __name__ == "__main__":
    if sys.argv[1:] == ["--moved"]:
        print("yes" if moved() else "")
    else:
        main(sys.argv[1], Path(sys.argv[2]))
