"""Stage `report`: write one page with all results."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

from placecat import files, paths, settings
from placecat.drawing.style import png_of
from placecat.provenance import lines, tidy
from placecat.provenance.cells import Explaining, Table
from placecat.provenance.text import explanations
from placecat.report.benchmarks import TEXT as BENCHMARK_TEXT
from placecat.report.benchmarks import shown_speed, speed_chart
from placecat.report.page import Figure, Report, page_html
from placecat.report.scale import TEXT as SCALE_TEXT
from placecat.report.scale import growth_chart, shown_scale
from placecat.runs.lockfile import LOCK, data_version
from placecat.sequences import listing
from placecat.stages import run
from placecat.thesis import in_text, notes
from placecat.thesis.tables import read

# Columns to read as text, even if their values look like numbers, such as section 4.10.
_TEXT = ("name", "section", "quantity", "home", "note")


def main() -> None:
    """Write index.html, results.parquet and explanations.json in reports/."""
    params = settings.load()
    dataset = settings.get(params, "dataset")
    tables = [Table(*one) for one in read(params)]
    noted = files.read_table(paths.NOTES, notes.COLUMNS)
    texts = notes.with_notes(in_text.NAME, files.read_table(paths.IN_TEXT, _TEXT), noted, in_text.KEY)
    comparisons = files.read_table(paths.COMPARISONS, _TEXT)
    origins = files.read_json(files.existing(paths.ORIGINS))
    cells = list(Explaining(params, tables, texts, origins, comparisons).cells())
    tidy.write(paths.RESULTS, tidy.tidy(cells))
    listing_stages = {stage for cell in cells for stage in cell.stages} & {"sequences", "site_sequences"}
    versions = {stage: data_version(stage) for stage in listing_stages}
    explained = explanations(cells, params, versions)
    files.write_text(paths.EXPLANATIONS, lines.to_text(explained))
    # Leave out later stages, which dvc.lock may not list yet.
    named = sorted({stage for cell in cells for stage in cell.stages})
    recorded = lines.stage_texts(settings.read_yaml(LOCK))
    report = Report(
        dataset=dataset,
        frames={home: _frames(home, dataset["classes"]) for home in dataset["homes"]},
        data_version=data_version(),
        tables=tables,
        figures=[
            _figure(one, params) for one in files.read_json(files.existing(paths.FIGURES / "figures.json"))
        ],
        in_text=texts,
        findings=files.read_table(paths.FINDINGS, _TEXT),
        comparisons=comparisons,
        settings=paths.PARAMS.read_text(encoding="utf-8"),
        replication=_if_kept(_replication, paths.REPLICATION_FACTS, paths.REPLICATED_FINDINGS),
        times=_if_kept(_times, paths.KEPT_TIMES_FACTS, paths.KEPT_TIMES),
        speed=_if_kept(_speed, paths.BENCHMARKS.with_suffix(".json"), paths.BENCHMARKS),
        scale=_if_kept(_scale, paths.SCALE_FACTS, paths.SCALE_STAGES, paths.SCALE_GROWTH),
        explanations=explained | {"stages": {stage: recorded[stage] for stage in named if stage in recorded}},
    )
    files.write_text(paths.PAGE, page_html(report))


def _frames(home: str, places: list[str]) -> dict[str, int]:
    labels = listing.read_labels(home)
    counts = {place: int((labels == number).sum()) for number, place in enumerate(places)}
    return counts | {"unlabelled": int((labels < 0).sum())}


def _figure(entry: dict[str, Any], params: dict[str, Any]) -> Figure:
    if entry["file"] is None:
        return Figure(entry["number"], entry["title"], None, entry["reason"], entry["name"])
    file = files.existing(paths.FIGURES / entry["file"])
    own = settings.flatten(params["figures"].get(entry["name"]) or {})
    return Figure(
        entry["number"],
        entry["title"],
        file.read_bytes(),
        name=entry["name"],
        pdf=file.with_suffix(".pdf").relative_to(paths.PAGE.parent).as_posix(),
        settings=", ".join(f"{name}={value}" for name, value in own.items()),
    )


def _if_kept(show: Callable[..., dict[str, Any] | None], *kept: Path) -> dict[str, Any] | None:
    """Show results from the given facts and tables, which are in git; return None if a file is missing."""
    facts, *tables = kept
    return show(files.read_json(facts), *tables) if all(path.is_file() for path in kept) else None


def _replication(facts: dict[str, Any], findings: Path) -> dict[str, Any]:
    return facts | {"findings": files.read_table(findings, _TEXT)}


def _times(facts: dict[str, Any], table: Path) -> dict[str, Any] | None:
    by_stage = files.read_table(table, ["stage"])
    return None if by_stage.empty else facts | {"stages": by_stage}


def _speed(facts: dict[str, Any], table: Path) -> dict[str, Any]:
    benchmarks = files.read_table(table, BENCHMARK_TEXT)
    return shown_speed(benchmarks, facts) | {"chart": png_of(speed_chart, benchmarks)}


def _scale(facts: dict[str, Any], *tables: Path) -> dict[str, Any]:
    """Show the run on data the size of the real home database."""
    measured, growth = (files.read_table(path, SCALE_TEXT) for path in tables)
    return shown_scale(measured, growth, facts) | {"chart": png_of(growth_chart, measured)}


if __name__ == "__main__":
    run(main)
