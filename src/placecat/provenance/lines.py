"""Lines that explain a cell, read from the file of all explanations.

This module imports little, so it stays fast.
"""

import hashlib
import json
from collections.abc import Mapping
from typing import Any

# A label and its text.
Line = tuple[str, str]
# Label of the line that lists the stages.
STAGES = "stages"


def lines_of(content: Mapping[str, Any], number: str) -> list[Line]:
    """Return the lines for a cell, from the result of :func:`placecat.provenance.text.explanations`."""
    lines: list[Line] = []
    for item in content["cells"][number]:
        shared = isinstance(item, int)
        lines += [content["lines"][line] for line in content["blocks"][item]] if shared else [item]
    return [(label, text) for label, text in lines]


def to_text(content: Mapping[str, Any]) -> str:
    """Format all explanations as JSON with one line per cell, so that git shows which cells changed."""
    parts = []
    for name, values in content.items():
        items = values.items() if isinstance(values, Mapping) else [(None, value) for value in values]
        rows = [("" if key is None else f"{_compact(key)}:") + _compact(value) for key, value in items]
        opening, closing = "{}" if isinstance(values, Mapping) else "[]"
        parts.append(f"{_compact(name)}:{opening}\n" + ",\n".join(rows) + f"\n{closing}")
    return "{" + ",\n".join(parts) + "}\n"


def _compact(value: Any) -> str:
    return json.dumps(value, ensure_ascii=False, separators=(",", ":"))


def stage_texts(lock: Mapping[str, Any]) -> dict[str, str]:
    """Map each stage in dvc.lock to its dependencies as text, with eight digits of each checksum.

    All dependencies in src/ share one checksum.
    """
    texts = {}
    for stage, record in lock["stages"].items():
        deps = {one["path"]: one.get("md5", "") for one in record.get("deps", [])}
        code = json.dumps(
            {path: md5 for path, md5 in deps.items() if path.startswith("src/")}, sort_keys=True
        )
        others = [f"{path} {md5[:8]}" for path, md5 in deps.items() if not path.startswith("src/")]
        texts[stage] = ", ".join([f"code {hashlib.sha256(code.encode()).hexdigest()[:8]}", *others])
    return texts
