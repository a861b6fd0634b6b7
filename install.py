"""Install the packages of a lock file and this project into .venv: ``python install.py LOCK_FILE MARKER``.

`make` calls it; it needs only the standard library. ``python install.py --moved`` prints "yes" if .venv does
not work here, since it was moved with the project or its Python is gone.
"""

import os
import re
import subprocess
import sys
from pathlib import Path

VENV = Path(".venv")
# Variables that would install packages outside .venv, or take some from elsewhere.
FOREIGN = ("PIP_CONSTRAINT", "PIP_PREFIX", "PIP_ROOT", "PIP_TARGET", "PYTHONHOME", "PYTHONPATH")


def main(lock: str, marker: Path) -> None:
    """Install, unless another `make` has just done so; wait for one that is still installing."""
    if not (3, 11) <= sys.version_info[:2] < (3, 14):
        sys.exit("placecat needs Python 3.11, 3.12 or 3.13: make PYTHON=python3.12 ...")
    with Path(".venv.lock").open("w") as held:
        _wait_for(held)
        is_moved = moved()
        if not is_moved and _is_newer(marker, (lock, "pyproject.toml")):
            return
        environment = {name: value for name, value in os.environ.items() if name not in FOREIGN}
        # As a variable, since pip's settings may set it too.
        environment |= {"PIP_USER": "0", "PYTHONNOUSERSITE": "1"}

        def run(*command: object) -> None:
            status = subprocess.run([str(part) for part in command], env=environment, check=False).returncode
            if status:
                sys.exit(status)

        run(sys.executable, "-m", "venv", *(["--clear"] if is_moved else []), VENV)
        # -qq: show errors, but no notices about this machine's pip.
        pip = (VENV / "bin/python", "-m", "pip", "install", "-qq", "--disable-pip-version-check")
        print(f"Installing what {lock} pins into {VENV}; the first time it takes minutes.", flush=True)
        run(*pip, "--require-hashes", "-r", lock)
        run(*pip, "--no-deps", "--no-build-isolation", "-e", ".")
        marker.touch()


def moved() -> bool:
    """Whether .venv exists but its programs do not start, since they contain an old path."""
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
        print("Another make installs into .venv: this one waits for it.", file=sys.stderr, flush=True)
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
