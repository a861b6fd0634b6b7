"""``placecat explain``: print where a number comes from.

The command does not import NumPy, so it takes only a second.
"""

import json
import shutil
import subprocess
import textwrap
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from placecat import paths, settings
from placecat.errors import PlacecatError
from placecat.explain.find import LABELS, find
from placecat.provenance.lines import STAGES, Line, lines_of, stage_texts
from placecat.runs.lockfile import LOCK, git_commit

_CODE = ("src", "conf", "data/thesis", "dvc.yaml", "params.yaml")
_INDENT = 24
# Maximum number of cells to explain at once.
_MOST = 3


def explain_command(words: Sequence[str], *, again: bool = False) -> int:
    """Explain the cells that match the words (see :func:`placecat.explain.find.find`).

    If several cells match, they are also listed; if more than `_MOST` match, they are only listed. With
    `again`, also recompute each cell that is explained. Returns the exit status, which is 1 if any recomputed
    number differs from the stored one.
    """
    content = read()
    numbers = find(words, content)
    if len(numbers) > _MOST:
        if again:
            raise PlacecatError(f"--again recomputes at most {_MOST} cells, but {_listed(numbers, content)}")
        print(_listed(numbers, content))
        return 0
    stages = stage_texts(settings.read_yaml(LOCK)) if LOCK.is_file() else {}
    print("\n\n".join(text_of(number, content, stages) for number in numbers))
    print(_shown(("code", _code())))
    same = _recompute(numbers) if again else True
    if len(numbers) > 1:
        # The list comes last, so that a terminal shows it.
        print(f"\n{_listed(numbers, content)}")
    return 0 if same else 1


def _recompute(numbers: Sequence[str]) -> bool:
    from placecat.explain.again import compute

    outcomes = [compute(number) for number in numbers]
    for _, said in outcomes:
        print(_shown(("again", said)))
    return all(is_same for is_same, _ in outcomes)


def read() -> dict[str, Any]:
    """Read the explanations of all cells; raise PlacecatError if their file is missing."""
    if not paths.EXPLANATIONS.is_file():
        raise PlacecatError(
            f"{paths.EXPLANATIONS} is missing here ({Path.cwd()}): run this in the project folder; if this "
            "is one, run `dvc repro`, or restore the file from git"
        )
    content: dict[str, Any] = json.loads(paths.EXPLANATIONS.read_text(encoding="utf-8"))
    return content


def text_of(number: str, content: Mapping[str, Any], stages: Mapping[str, str]) -> str:
    """Format a cell's explanation for the terminal; `stages` comes from :func:`stage_texts`."""
    lines: list[Line] = [("cell", number)]
    for label, text in lines_of(content, number):
        if label == STAGES:
            lines += [
                (f"stage {name}", f"made from {stages[name]}" if name in stages else f"not in {LOCK}")
                for name in text.split()
            ]
        else:
            lines.append((label, text))
    return "\n".join(map(_shown, lines))


def _listed(numbers: Sequence[str], content: Mapping[str, Any]) -> str:
    """List cells with their labels and numbers, and say how to choose one."""
    rows: list[tuple[str, ...]] = [("cell", *LABELS, "measured", "published")]
    for number in numbers:
        lines = dict(lines_of(content, number))
        # The numbers of the seeds and the difference follow.
        measured, published = lines["here"].partition(" (")[0], lines.get("thesis", "").partition(";")[0]
        rows.append((number, *(lines.get(kind, "") for kind in LABELS), measured, published))
    columns = [column for column in zip(*rows, strict=True) if any(column[1:])]
    padded = [[text.ljust(max(map(len, column))) for text in column] for column in columns]
    table = "\n".join("  ".join(row).rstrip() for row in zip(*padded, strict=True))
    choose = f"To explain only one of them, add a label or use its number: placecat explain {numbers[0]}"
    return f"{len(numbers)} cells match:\n\n{table}\n\n{choose}"


def _shown(line: Line) -> str:
    label, text = line
    width = max(shutil.get_terminal_size().columns, 60)
    head = f"{label:{_INDENT - 2}}  "
    return textwrap.fill(
        text,
        width,
        initial_indent=head,
        subsequent_indent=" " * _INDENT,
        break_on_hyphens=False,
        break_long_words=False,
    )


def _code() -> str:
    """Describe the current commit and any changes to code or settings since then."""
    commit = git_commit()
    if not commit:
        return "outside a git repository"
    command = ["git", "status", "--porcelain", "--", *_CODE]
    changed = subprocess.run(command, capture_output=True, text=True, check=False).stdout.splitlines()
    names = ", ".join(line[3:] for line in changed[:3]) + (" and more" if len(changed) > 3 else "")
    return f"commit {commit}, {f'with uncommitted changes: {names}' if changed else 'nothing changed since'}"
