"""Report the results of a search."""

import shlex
from collections.abc import Sequence
from pathlib import Path

from placecat import files
from placecat.search.space import Space
from placecat.search.study import Tried, best
from placecat.templates import environment

SUMMARY = "search.md"
_PROGRAM = ("placecat", "experiment")
# Settings that differ between search and test, or that always keep their default.
_REPLACED = ("search", "judge", "test_home", "track", "data=main")


def write(folder: Path, tried: Sequence[Tried], space: Space, base: dict[str, str], home: str) -> str:
    """Write a summary to the folder of the sweep; return it as Markdown.

    `tried` lists the settings that were tried, beginning with the starts of the search. `base` maps
    ``descriptor``, ``classifier`` and ``data`` to their chosen options. `home` is the test home, which the
    search did not use.
    """
    starts, found = dict(zip(space.starts, tried, strict=False)), best(tried)
    without = [one for one in tried if one.accuracy is None]
    own = [one for one in space.fixed if one.lstrip("+").split("=", 1)[0] not in base]
    common = [
        one
        for one in (*(f"{key}={value}" for key, value in base.items()), *own)
        if one not in _REPLACED and one.lstrip("+").split("=", 1)[0] not in _REPLACED
    ]

    def command(one: Tried) -> str:
        return shlex.join([*_PROGRAM, *common, *one.overrides, f"test_home={home}", "judge=test_home"])

    text = (
        environment("placecat.search")
        .get_template("search.md.j2")
        .render(
            starts=starts,
            rows=[*starts.items(), (f"best of {len(tried)}", found)],
            found=found,
            count=len(tried),
            without=len(without),
            common=common,
            home=home,
            command=command,
        )
    )
    files.write_text(folder / SUMMARY, text)
    return text
