"""`make help` lists every target."""

import re
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]


def test_make_help_names_every_target_in_one_line():
    targets = re.search(r"^\.PHONY: (help .*)$", (ROOT / "Makefile").read_text(), re.MULTILINE)[1].split()
    # `make test` says that it enters a folder.
    for command in (["make", "--no-print-directory", "help"], ["make", "--no-print-directory"]):
        shown = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True).stdout
        assert sorted(line.split()[1] for line in shown.splitlines()) == sorted(targets)
        assert all(len(line.split(maxsplit=2)) == 3 for line in shown.splitlines())
