"""Report the results of a search."""

import shlex
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import yaml

from placecat import files
from placecat.search.space import Space, values
from placecat.search.study import Tried, best

RESULTS = "optimization_results.yaml"
SUMMARY = "search.md"
_PROGRAM = "placecat experiment"
# Settings that differ between search and test, or that keep their default.
_REPLACED = ("search", "judge", "test_home", "track", "data=main")


def write(folder: Path, tried: Sequence[Tried], space: Space, base: dict[str, str], home: str) -> str:
    """Write the results and a summary to the sweep's folder; return the summary as Markdown.

    `tried` lists the settings that were tried, starts first. `base` maps ``descriptor``, ``classifier`` and
    ``data`` to their chosen options. `home` is the test home, which the search did not use.
    """
    starts, found = dict(zip(space.starts, tried, strict=False)), best(tried)
    without = [one for one in tried if one.accuracy is None]
    content = {
        "name": "optuna",
        "best_params": _values(found),
        "best_value": found.accuracy,
        "best_experiment": found.number,
        "starts": {
            name: {"params": _values(one), "value": one.accuracy, "experiment": one.number}
            for name, one in starts.items()
        },
        "experiments": len(tried),
        "without_number": len(without),
    }
    files.write_text(folder / RESULTS, yaml.safe_dump(content, sort_keys=False))
    own = [one for one in space.fixed if one.lstrip("+").split("=", 1)[0] not in base]
    common = [
        one
        for one in (*(f"{key}={value}" for key, value in base.items()), *own)
        if one not in _REPLACED and one.lstrip("+").split("=", 1)[0] not in _REPLACED
    ]
    text = _text(starts, found, len(tried), len(without), common, home)
    files.write_text(folder / SUMMARY, text)
    return text


def _text(
    starts: dict[str, Tried], found: Tried, count: int, without: int, common: Sequence[str], home: str
) -> str:
    rows = [*starts.items(), (f"best of {count}", found)]
    lines = [
        f"# Search: {' '.join(common)}",
        "",
        f"Mean accuracy in percent with each training home left out in turn; {home} was not used.",
        "",
        "| setting | experiment | accuracy | overrides |",
        "| --- | ---: | ---: | --- |",
    ]
    lines += [
        f"| {name} | {one.number} | {'-' if one.accuracy is None else f'{one.accuracy:.2f}'} "
        f"| {' '.join(one.overrides)} |"
        for name, one in rows
    ]
    if without:
        lines += ["", f"{without} of the experiments have no result: see summary.csv."]
    if found in starts.values():
        lines += ["", "The search found nothing better. This command tests the settings on the test home:"]
    else:
        lines += [
            "",
            f"The accuracy of the best of {count} is too optimistic, since it decided the choice. Test the "
            "settings once on the test home, after all choices are made:",
        ]
    lines += ["", f"    {_command(found, common, home)}", ""]
    for name, one in starts.items():
        if one is not found and one.accuracy is not None:
            lines += [f"For comparison, {name}:", "", f"    {_command(one, common, home)}", ""]
    return "\n".join(lines)


def _command(one: Tried, common: Sequence[str], home: str) -> str:
    arguments = [*common, *one.overrides, f"test_home={home}", "judge=test_home"]
    return f"{_PROGRAM} {shlex.join(arguments)}"


def _values(one: Tried) -> dict[str, Any]:
    """Map keys to values, parsed as YAML."""
    return {key: yaml.safe_load(value) for key, value in values(one.overrides).items()}
