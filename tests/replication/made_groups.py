"""A project folder for `placecat replicate`, in which stages immediately write random results."""

import shutil
from dataclasses import replace

import pandas as pd

import made_results
from placecat import files, paths, settings

HOMES = [f"home_{number}" for number in range(1, 13)]
OVERRIDES = [f"dataset.homes=[{','.join(HOMES)}]", "verdict.resamples=100"]


def compared():
    """Return the names of all results that findings compare, including other readings."""
    of_sides = (
        pd.read_csv(made_results.ROOT / paths.COMPARISONS)[["left_results", "right_results"]].stack().dropna()
    )
    return {name for names in of_sides for name in names.split("; ")}


def write_scores(folder, params, drawn):
    """Write random scores for all compared results."""
    made = made_results.made(params, drawn)
    few = {name: one for name, one in made.measured.items() if name in COMPARED}
    made_results.write_scores(folder / paths.SCORES, replace(made, measured=few, quality={}))


COMPARED = compared()


def make_project(folder):
    """Copy the definitions and the ledger of the six homes, and imitate the outputs of `make repro`."""
    for name in ("conf", "data/thesis"):
        shutil.copytree(made_results.ROOT / name, folder / name)
    for name in ("dvc.yaml", "params.yaml", *(str(path) for path in (paths.FINDINGS, paths.COMPARISONS))):
        (folder / name).parent.mkdir(exist_ok=True)
        shutil.copy(made_results.ROOT / name, folder / name)
    (folder / "src").mkdir()
    for name in ("data/site_sequences", "data/site_features", "data/splits", "data/homes"):
        (folder / name).mkdir()
    (folder / paths.TOY).write_text("")
    for path in (paths.BENCHMARKS, paths.SCALE_STAGES):
        shutil.copy(made_results.ROOT / path, folder / path)
    write_scores(folder, made_results.PARAMS, 0)


def make_stage(ran, fails_at=None):
    """Return a mock stage that records folder and stage in `ran`; only `scores` and `tables` write files."""

    def run_stage(folder, stage, command):
        ran.append((folder.name, stage))
        if (folder.name, stage) == fails_at:
            raise KeyboardInterrupt
        number = int(folder.name.removeprefix("group_"))
        if stage == "scores":
            write_scores(folder, settings.load(folder / paths.PARAMS), number)
        if stage == "tables":
            head = "table,group,row,column,published,measured,spread,seeds,note"
            text = f"{head}\n26,,HMM,Average,40.0,50.0,,0,a note\n"
            files.write_text(folder / paths.TABLES / "table_26.csv", text)

    return run_stage
