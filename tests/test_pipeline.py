"""The complete pipeline, run from scratch with real DVC."""

import json
import shutil

import numpy as np
import pandas as pd
import pytest

from placecat import files
from placecat.config.compose import compose
from placecat.training import fold_file
from project import HOMES, ROOT, SMALL, commit, contents, copy_project, light_conf, rendered, repro, run

pytestmark = pytest.mark.xdist_group("pipeline")


KEY = ["group", "row", "column"]
TABLES = {f"table_{number:02d}" for number in range(1, 32)} | {
    "addition_as_printed",
    "addition_attention",
    "addition_discriminative_regions",
    "addition_filter",
    "addition_hmm",
    "addition_probabilities",
    "addition_rvm",
    "addition_toy",
    "addition_votes",
}
# Tables for which the homes are too small, or too few.
TOO_SMALL = {1, 2, 4, 22}
RANDOM_TABLES = {5, 8, 11, 12, 13, *range(16, 29), 30, 31}


def test_every_stage_runs_once_and_every_cell_has_a_number_or_a_reason(reproduced):
    folder, ran, _ = reproduced
    listed = run(folder, "dvc", "stage", "list", "--name-only").stdout.split()
    assert sorted([*ran, "render"]) == sorted(listed)
    # Each stage makes DVC slower; see dvc.yaml.
    assert len(ran) == 20
    assert {path.stem for path in (folder / "reports/tables").glob("*.csv")} == TABLES
    published = files.read_table(ROOT / "data/thesis/published_tables.csv", KEY)
    for name in TABLES:
        table = files.read_table(folder / f"reports/tables/{name}.csv", KEY)
        columns = ["table", "group", "row", "column", "published", "measured", "spread", "seeds", "note"]
        assert list(table.columns) == columns
        assert table["note"].str.len().min() > 10
        assert table["measured"].dropna().between(0, 100).all()
        for ending in ("md", "tex"):
            assert (folder / f"reports/tables/{name}.{ending}").stat().st_size > 250
        if name.startswith("addition"):
            continue
        number = int(name[-2:])
        own = published[published["table"] == number]
        assert len(table) >= len(own)
        keys = table[KEY].iloc[: len(own)].reset_index(drop=True)
        pd.testing.assert_frame_equal(keys, own[KEY].reset_index(drop=True))
        numbers = table["measured"].notna()
        if number in TOO_SMALL:
            continue
        assert (table.loc[numbers, "seeds"] == (2 if number in RANDOM_TABLES else 0)).any(), name


def test_findings_figures_metrics_and_numbers_in_the_text_are_there(reproduced):
    folder, _, _ = reproduced
    findings = pd.read_csv(folder / "reports/findings.csv")
    assert findings["number"].tolist() == list(range(1, 35))
    assert set(findings["verdict"]) <= {"holds", "does not hold", "undecided"}
    judged = findings[findings["verdict"] != "undecided"]
    assert len(judged)
    assert judged[["difference", "low", "high"]].notna().all(axis=None)
    figures = json.loads((folder / "reports/figures/figures.json").read_text())
    assert [one["number"] for one in figures] == [2, 3, 4, 5, 6, 7, 9, *range(11, 21), None]
    drawn = [one for one in figures if one["file"]]
    assert len(drawn) >= 15
    for one in drawn:
        assert (folder / "reports/figures" / one["file"]).read_bytes().startswith(b"\x89PNG")
    assert all(one["reason"] for one in figures if not one["file"])
    text = pd.read_csv(folder / "reports/in_text.csv")
    assert {"gist_without_color", "flat_kmeans", "extra_das_data", "toy_problem"} <= set(text["name"])
    metrics = json.loads((folder / "reports/metrics.json").read_text())
    table = pd.read_csv(folder / "reports/tables/table_29.csv")
    measured = table.loc[(table["row"] == "Sequential") & (table["column"] == "Average"), "measured"].item()
    assert measured in list(numbers_in(metrics["table_29"]))


def numbers_in(content):
    """Yield every number in nested mappings."""
    if isinstance(content, dict):
        for value in content.values():
            yield from numbers_in(value)
    else:
        yield content


@pytest.fixture
def copy(reproduced, tmp_path):
    """A copy of the reproduced folder that may be changed."""
    return shutil.copytree(reproduced[0], tmp_path / "copy", symlinks=True)


def test_dvc_knows_the_tables_as_metrics_and_draws_its_plots(copy):
    commit(copy)
    path = copy / "reports/metrics.json"
    metrics = json.loads(path.read_text())
    before = metrics["table_26"]
    first = next(numbers_in(before))
    path.write_text(path.read_text().replace(f": {first}", f": {first + 1}"))
    shown = json.loads(run(copy, "dvc", "metrics", "diff", "--json", "HEAD", "--targets", str(path)).stdout)
    changed = shown["reports/metrics.json"]
    assert changed
    assert all(change["diff"] == pytest.approx(1) for change in changed.values())
    run(copy, "dvc", "plots", "diff", "HEAD", "-o", "plots", "-q")
    assert "Accuracy by home" in (copy / "plots/index.html").read_text()


def test_the_features_are_memory_mappable_and_nothing_is_pickled(reproduced):
    folder, _, _ = reproduced
    hog = np.load(folder / "data/features/Home1/local_hog.npy", mmap_mode="r", allow_pickle=False)
    frames = pd.read_csv(folder / "data/sequences/Home1/frames.csv")
    assert hog.shape == (len(frames), 38, 128)
    endings = {path.suffix for path in (folder / "data").rglob("*") if path.is_file()}
    assert endings <= {".npy", ".npz", ".placecat", ".json", ".csv", ".jpg", ".txt", ".yaml", ""}, endings


def test_a_second_repro_has_nothing_to_do(reproduced):
    ran, _ = repro(reproduced[0])
    assert ran == []


def test_the_videos_are_checked_and_never_rendered(reproduced, copy):
    """Neither a new video nor a changed renderer starts the frozen stage, which takes about an hour."""
    _, _, output = reproduced
    assert "Verifying outputs in frozen stage: 'render'" in output
    (copy / rendered()[0] / "other.mp4").write_bytes(b"")
    for name in ("__init__", "render"):
        source = copy / f"src/placecat_homes/{name}.py"
        source.write_text(f"{source.read_text()}\n")
    ran, result = repro(copy)
    assert ran == []
    assert "Verifying outputs in frozen stage: 'render'" in result.stdout
    assert (copy / rendered()[0] / "other.mp4").exists()


# This test only reads the reproduced folder, so the other worker can run it.
@pytest.mark.xdist_group("later")
def test_two_runs_from_scratch_give_the_same_bytes(reproduced, tmp_path):
    """This also holds with more workers, more threads and the kernels that OpenBLAS chooses on its own."""
    folder, _, _ = reproduced
    again = copy_project(tmp_path)
    # The page shows the checksum of the data, which is in dvc.lock.
    shutil.copy(folder / "dvc.lock", again)
    other = {"PLACECAT_WORKERS": "2", "OPENBLAS_NUM_THREADS": "2", "OMP_NUM_THREADS": "2"}
    run(again, "python", ROOT / "tests/every_stage.py", OPENBLAS_CORETYPE="", **other)
    computed = ("features", "tracks", "codebooks", "cues", "smoothing", "site_features", "splits", "trials")
    parts = ("reports", "data/model.placecat", "data/scores", *(f"data/{part}" for part in computed))
    first, second = contents(folder, *parts), contents(again, *parts)
    assert first.keys() == second.keys()
    assert [name for name in first if first[name] != second[name]] == []


@pytest.mark.parametrize("system", ["das_551_best", "das_451_all", "das_551_tracked", "das_551_extra"])
def test_frame_by_frame_gives_the_bits_of_the_pipeline(reproduced, tmp_path, monkeypatch, system):
    """A saved system that was trained without a home classifies the frames of this home as the stages do."""
    from placecat import settings
    from placecat.categorizer import Categorizer, model_file
    from placecat.categorizer.train import train
    from placecat.footage.frames import read_frames
    from placecat.sequences import listing

    folder, _, _ = reproduced
    monkeypatch.chdir(folder)
    monkeypatch.setenv("PLACECAT_WORKERS", "1")
    params = settings.load()
    model_file.write(tmp_path / "model.placecat", train(params, system, without=["Home3"], seed=1))
    categorizer = Categorizer.load(tmp_path / "model.placecat", classes=params["dataset"]["classes"])
    frames = listing.read_frames("Home3")
    decisions = []
    for part in listing.sequence_slices("Home3"):
        categorizer.reset()
        for image in read_frames(folder / HOMES, frames.iloc[part], size=categorizer.frame_sizes[0]):
            decisions.append(categorizer.update(image))
    for stage, name, attribute in (
        ("integration", "test", "integrated"),
        ("smoothing", "hmm", "hmm"),
        ("smoothing", "delayed", "proba"),
    ):
        expected = fold_file.read(folder / "data" / stage / system / "Home3.seed-1.npz", name)
        np.testing.assert_array_equal([getattr(one, attribute) for one in decisions], expected)


def test_changing_one_cue_recomputes_only_what_depends_on_it(copy):
    overrides = [*SMALL, "cues.hog_tracked.classifier.base.alpha=0.5"]
    (copy / "params.yaml").write_text(compose(overrides, conf=copy / "conf"))
    # DVC runs these stages because params.yaml has changed, but they find few or no items to recompute.
    stages = ("codebooks", "site_features", "cues", "integration", "trials")
    before = inodes(copy, *stages)
    ran, _ = repro(copy, "integration", "trials")
    assert set(ran) == set(stages)
    after = inodes(copy, *stages)
    changed = {path.parent.name for path, inode in after.items() if before[path] != inode}
    assert changed == {"hog_tracked", "das_551_tracked"}


def test_changing_one_home_recomputes_only_its_features(copy):
    frame = next((copy / HOMES / "Home2").rglob("*.jpg"))
    content = next((copy / HOMES / "Home3").rglob("*.jpg")).read_bytes()
    frame.unlink()
    frame.write_bytes(content)
    result = run(copy, "dvc", "repro", "--single-item", "sequences")
    assert "Running stage 'sequences'" in result.stdout
    before = inodes(copy, "features")
    ran, _ = repro(copy, "--single-item", "features")
    assert ran == ["features"]
    assert {
        path.parent.name for path, inode in inodes(copy, "features").items() if before[path] != inode
    } == {"Home2"}


def inodes(folder, *stages):
    """Map the manifest of each item to its inode, which changes if the manifest is written again."""
    found = [path for stage in stages for path in (folder / "data" / stage).glob("*/manifest.json")]
    return {path: path.stat().st_ino for path in found}


@pytest.mark.parametrize(
    ("damage", "message"),
    [
        (lambda homes: next((homes / "Home2").rglob("00000003.jpg")).unlink(), "00000003.jpg"),
        (lambda homes: shutil.rmtree(homes / "Home3"), "Home3"),
        (lambda homes: replace(homes / "Home1/label.txt", "kitchen", "kitchn"), "kitchn"),
        (lambda homes: replace(homes / "Home1/label.txt", "bathroom", "corridor"), "bathroom"),
        (lambda homes: drop_line(homes / "Home1/label.txt", 5), "Home1/label.txt"),
        (lambda homes: [path.unlink() for path in (homes / "Home2").rglob("*.jpg")], "Home2"),
    ],
    ids=["missing frame", "missing home", "unknown class", "home without a class", "gap", "empty home"],
)
def test_damaged_data_gives_one_message_and_leaves_nothing(reproduced, tmp_path, damage, message):
    folder, _, _ = reproduced
    shutil.copytree(folder / HOMES, tmp_path / HOMES)
    shutil.copy(folder / "params.yaml", tmp_path / "params.yaml")
    damage(tmp_path / HOMES)
    result = run(tmp_path, "python", "-m", "placecat.stages.sequences", check=False)
    check_refused(result, message)
    assert not any((tmp_path / "data/sequences").parent.glob("*sequences*"))


def test_an_unreadable_image_gives_one_message_and_leaves_nothing(reproduced, tmp_path):
    folder, _, _ = reproduced
    for part in (HOMES, "data/sequences"):
        shutil.copytree(folder / part, tmp_path / part)
    shutil.copy(folder / "params.yaml", tmp_path / "params.yaml")
    frame = next((tmp_path / HOMES / "Home2").rglob("00000003.jpg"))
    frame.write_bytes(frame.read_bytes()[:200])
    result = run(tmp_path, "python", "-m", "placecat.stages.features", check=False)
    check_refused(result, "00000003.jpg")
    assert not (tmp_path / "data/features/Home2").exists()
    assert not any((tmp_path / "data/features").glob(".*"))


@pytest.fixture(scope="module")
def light(tmp_path_factory):
    return light_conf(tmp_path_factory.mktemp("light") / "conf")


@pytest.mark.parametrize(
    ("override", "stage", "message", "workers"),
    [
        ("cues.gist.classifier.base.nu=1.5", "cues", "nu=1.5: it must be less than or equal to 1", "1"),
        # This error is raised in a worker process. The other cases use one worker, which is faster.
        (
            "cues.gist.classifier.base={nu_policy: refuse, nu: 0.9}",
            "cues",
            "nu = 0.9 is infeasible for class 'bedroom'",
            "2",
        ),
        ("cues.hog_y.classifier.clusters=47", "cues", "46", "1"),
        ("cues.hog_y.classifier.clusters=61", "cues", "46", "1"),
        ("cues.hog_y.classifier.base.alfa=1", "cues", "'alfa'", "1"),
        ("codebooks.hog_y.tree.max_clusters=40", "codebooks", "31 ", "1"),
    ],
)
def test_invalid_settings_give_one_message_and_leave_nothing(
    reproduced, light, tmp_path, override, stage, message, workers
):
    folder, _, _ = reproduced
    (tmp_path / "data").mkdir()
    for part in (folder / "data").iterdir():
        if part.name != stage:
            (tmp_path / "data" / part.name).symlink_to(part)
    # Copy the existing items, so that they are not made again.
    shutil.copytree(folder / "data" / stage, tmp_path / "data" / stage, symlinks=True)
    shutil.copy(folder / "dvc.yaml", tmp_path)
    (tmp_path / "src").symlink_to(folder / "src")
    before = inodes(tmp_path, stage)
    (tmp_path / "params.yaml").write_text(compose([*SMALL, f"++{override}"], conf=light))
    command = ("python", "-m", f"placecat.stages.{stage}")
    result = run(tmp_path, *command, check=False, PLACECAT_WORKERS=workers)
    check_refused(result, message)
    assert inodes(tmp_path, stage) == before


def replace(file, old, new):
    file.chmod(0o644)
    text = file.read_text()
    assert old in text
    file.write_text(text.replace(old, new))


def drop_line(file, number):
    file.chmod(0o644)
    lines = file.read_text().splitlines(keepends=True)
    file.write_text("".join(lines[: number - 1] + lines[number:]))


def check_refused(result, message):
    """Check that the status is 1 and that one line without a traceback contains the message."""
    assert result.returncode == 1
    lines = [line for line in result.stderr.splitlines() if line.startswith("placecat: ")]
    assert len(lines) == 1
    assert message in lines[0]
    assert "Traceback" not in result.stderr
