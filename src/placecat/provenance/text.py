"""Explanations as labelled lines. Lines that many cells share are stored only once."""

from collections.abc import Iterable, Mapping
from typing import Any

from placecat import settings
from placecat.paths import NO_SEED
from placecat.provenance.cells import Explained, quantity
from placecat.provenance.frames import Frames, Trained
from placecat.provenance.lines import STAGES, Line
from placecat.provenance.made import Made


def explanations(
    cells: Iterable[Explained], params: Mapping[str, Any], data_versions: Mapping[str, str]
) -> dict[str, Any]:
    """Collect all explanations in JSON types.

    `params` contains all settings. `data_versions` maps each stage that lists frames to DVC's checksum of
    that list. Returns ``lines``, ``blocks`` and ``cells``. Each line consists of a label and text. Each
    block is a list of line numbers, which start at 0. ``cells`` maps the number of each cell to an ordered
    list that explains it. Each item of this list is a line or the number of a block.
    """
    pool: dict[Line, int] = {}
    blocks: dict[tuple[int, ...], int] = {}
    found: dict[str, list[Any]] = {}

    def shared(lines: Iterable[Line]) -> int:
        block = tuple(pool.setdefault(line, len(pool)) for line in lines)
        return blocks.setdefault(block, len(blocks))

    for cell in cells:
        labels = [("table", cell.title), *[("group", cell.group)] * bool(cell.group), ("row", cell.row)]
        found[cell.id] = [
            shared(labels),
            shared([("column", cell.column)]),
            ("here", _here(cell)),
            *[("thesis", _thesis(cell))] * (cell.published == cell.published),
            shared(("note", note.text) for note in cell.notes),
            shared(("what", quantity(origin, cell.home)) for origin in dict.fromkeys(cell.origins)),
            shared(("result", one.title) for one in cell.made),
            *(shared(_frames(one)) for of_home in cell.trained.values() for one in of_home),
            *(shared(_settings(one, params)) for one in cell.made),
            shared(_end(cell, data_versions)),
        ]
    return {"lines": list(pool), "blocks": list(blocks), "cells": found}


def settings_text(values: Mapping[str, Any]) -> str:
    """Format settings on one line, such as "gamma=2.0, base.nu=0.2"."""
    return ", ".join(f"{name}={value}" for name, value in settings.flatten(values).items())


def _here(cell: Explained) -> str:
    if not cell.measurement.values:
        return "no number"
    text = f"{cell.measured:.10g}{_unit(cell.unit)}"
    if cell.measurement.seeds == (NO_SEED,):
        return f"{text} (nothing is random)"
    pairs = zip(cell.measurement.seeds, cell.measurement.values, strict=True)
    of_seeds = ", ".join(f"{seed} {value:.2f}" for seed, value in pairs)
    return f"{text} ({of_seeds})"


def _thesis(cell: Explained) -> str:
    text = f"{cell.published:.10g}"
    return text if cell.difference != cell.difference else f"{text}; difference {cell.difference:+.2f}"


def _unit(unit: str) -> str:
    return {"percent": " %", "": ""}.get(unit, f" {unit}")


def _settings(made: Made, params: Mapping[str, Any]) -> list[Line]:
    lines = [(part, settings_text(values)) for part, values in made.settings.items()]
    dataset = settings.get(params, "dataset.name") if made.plan in ("5-5-1", "4-5-1") else made.plan
    seeds = ", ".join(map(str, settings.get(params, "protocol.seeds")))
    for cue, (descriptor, cells) in made.clusters.items():
        parts = f'"codebook", {dataset!r}, {descriptor!r}, {cells}, TRAINING SET, SEED'
        lines.append((f"seeds of {cue}", f"derived from {parts}, with the seeds {seeds}"))
    return lines


def _frames(one: Trained) -> list[Line]:
    lines = [
        ("tested on", _listed(one.tested)),
        ("cues trained on", f"{_listed(one.cues)} (training set {one.training_set!r})"),
    ]
    if one.integration:
        lines.append(("integration trained on", _listed(one.integration)))
    return lines


def _listed(frames: Frames) -> str:
    total = sum(count for _, count in frames)
    if len(frames) == 1:
        return f"{total} frames of {frames[0][0]}"
    return f"{total} frames: {', '.join(f'{home} {count}' for home, count in frames)}"


def _end(cell: Explained, data_versions: Mapping[str, str]) -> list[Line]:
    lines: list[Line] = []
    if cell.findings:
        lines.append(("findings", f"{', '.join(cell.findings)} (based on the same results)"))
    lines += [
        ("data", f"{cell.data[0]}, checksum {data_versions[stage]}")
        for stage in cell.stages
        if stage in data_versions
    ]
    return [*lines, (STAGES, " ".join(cell.stages))]
