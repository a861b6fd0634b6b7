"""The command line: ``placecat params``, ``placecat repro``."""

import argparse
import os
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

from placecat import paths
from placecat.compose import write_params
from placecat.errors import PlacecatError

_OVERRIDES = "Hydra overrides of conf/, e.g. dataset=my_homes dataset.root=PATH"


def main(arguments: Sequence[str] | None = None) -> None:
    """Run a subcommand; a mistake of the user's ends with its message and status 1."""
    parser = argparse.ArgumentParser(
        prog="placecat", description="Visual place categorization, reproducibly."
    )
    commands = parser.add_subparsers(dest="command", required=True)
    for name, text in (("params", "write params.yaml"), ("repro", "write params.yaml and run dvc repro")):
        command = commands.add_parser(name, help=text, description=f"{text.capitalize()}.")
        command.add_argument("overrides", nargs="*", metavar="OVERRIDE", help=_OVERRIDES)
    options = parser.parse_args(arguments)
    try:
        write_params(options.overrides)
        if options.command == "repro":
            sys.exit(_repro())
    except PlacecatError as error:
        sys.exit(f"placecat: {error}")
    except KeyboardInterrupt:
        sys.exit(130)


def _repro() -> int:
    """Run `dvc repro` with this environment's Python first on the path, since the stages call `python`."""
    here = str(Path(sys.executable).parent)
    environment = os.environ | {"PATH": os.pathsep.join([here, os.environ.get("PATH", "")])}
    status = subprocess.run([sys.executable, "-m", "dvc", "repro"], env=environment, check=False).returncode
    table = paths.TABLES / "table_26.md"
    if status == 0 and table.exists():
        print(f"\n{table.read_text(encoding='utf-8').split('## Published')[0].strip()}\n")
        print(f"All tables: {paths.TABLES}; the page: {paths.PAGE}; `make ui` opens MLflow.")
    return status


if __name__ == "__main__":
    main()
