"""The pipeline from nothing, through real DVC."""

import shutil

import pandas as pd
import pytest
import yaml

from project import HOMES, ROOT, SMALL, compose, contents, copy_project, rendered, repro, run

pytestmark = pytest.mark.xdist_group("pipeline")


def test_every_stage_runs_once_and_every_cell_has_a_number_or_a_reason(reproduced):
    folder, ran, _ = reproduced
    assert len(ran) == len(set(ran)) == 31
    params = yaml.safe_load((folder / "params.yaml").read_text())
    names = {path.stem for path in (folder / "reports/tables").glob("*.csv")}
    assert (
        names
        == {f"table_{number:02d}" for number in (5, 6, 7, 8, 9, 10, 23, 26, 29)}
        == set(params["tables"])
    )
    published = pd.read_csv(ROOT / "data/thesis/published_tables.csv")
    for name in names:
        table = pd.read_csv(folder / f"reports/tables/{name}.csv")
        assert list(table.columns) == ["table", "group", "row", "column", "published", "measured", "note"]
        assert len(table) == (published["table"] == int(name[-2:])).sum()
        assert (
            table.loc[table["measured"].isna(), "note"].str.startswith("the data set has only 4 homes").all()
        )
        assert table["measured"].notna().sum() >= 10
        assert table["measured"].dropna().between(0, 100).all()
        assert (folder / f"reports/tables/{name}.md").read_text().startswith(f"# Table {int(name[-2:])}: ")


def test_the_features_are_memory_mappable_and_nothing_is_pickled(reproduced):
    folder, _, _ = reproduced
    import numpy as np

    hog = np.load(folder / "data/features/Home1/local_hog.npy", mmap_mode="r", allow_pickle=False)
    frames = pd.read_csv(folder / "data/sequences/Home1/frames.csv")
    assert hog.shape == (len(frames), 25, 128)
    endings = {path.suffix for path in (folder / "data").rglob("*") if path.is_file()}
    assert endings <= {".npy", ".npz", ".json", ".csv", ".jpg", ".txt", ""}


def test_a_second_repro_has_nothing_to_do(reproduced):
    folder, _, _ = reproduced
    ran, _ = repro(folder)
    assert ran == []


def test_the_videos_are_checked_and_never_rendered(reproduced, tmp_path):
    """Neither another video nor another renderer starts the frozen stage, which takes hours."""
    folder, _, result = reproduced
    assert "Verifying outputs in frozen stage: 'render'" in result.stdout
    copy = tmp_path / "copy"
    shutil.copytree(folder, copy, symlinks=True)
    (copy / rendered()[0] / "other.mp4").write_bytes(b"")
    for source in (copy / "src/placecat/stages/render.py", copy / "src/placecat/rendering/__init__.py"):
        source.write_text(f"{source.read_text()}\n")
    ran, result = repro(copy)
    assert ran == []
    assert "Verifying outputs in frozen stage: 'render'" in result.stdout
    assert (copy / rendered()[0] / "other.mp4").exists()


def test_two_runs_from_nothing_give_the_same_bytes(reproduced, tmp_path):
    """On another number of workers, and whatever kernels OpenBLAS would choose by itself, too."""
    folder, _, _ = reproduced
    again = copy_project(tmp_path)
    repro(again, PLACECAT_WORKERS="1", OMP_NUM_THREADS="2", OPENBLAS_CORETYPE="")
    parts = (
        "reports",
        "data/features",
        "data/codebooks",
        "data/cues",
        "data/smoothing",
        "data/tracking.json",
    )
    first, second = contents(folder, *parts), contents(again, *parts)
    assert first.keys() == second.keys()
    assert [name for name in first if first[name] != second[name]] == []


def test_changing_one_cue_runs_that_cue_and_what_follows_only(reproduced, tmp_path):
    folder, _, _ = reproduced
    copy = tmp_path / "copy"
    shutil.copytree(folder, copy, symlinks=True)
    overrides = [*SMALL, "cues.hog_y.classifier.base.alpha=0.5"]
    (copy / "params.yaml").write_text(compose(overrides, conf=copy / "conf"))
    ran, _ = repro(copy)
    systems = yaml.safe_load((copy / "params.yaml").read_text())["systems"]
    expected = {"cues@hog_y", *(f"integration@{name}" for name in systems), "smoothing", "tables", "report"}
    assert set(ran) - {"tracking"} == expected


def test_changing_one_home_describes_that_home_only(reproduced, tmp_path):
    folder, _, _ = reproduced
    copy = tmp_path / "copy"
    shutil.copytree(folder, copy, symlinks=True)
    frame = next((copy / HOMES / "Home2").rglob("*.jpg"))
    content = next((copy / HOMES / "Home3").rglob("*.jpg")).read_bytes()
    frame.unlink()
    frame.write_bytes(content)
    result = run(copy, "dvc", "repro", "--single-item", "sequences")
    assert "Running stage 'sequences'" in result.stdout
    features = [f"features@Home{number}" for number in (1, 2, 3, 4)]
    ran, _ = repro(copy, "--single-item", *features)
    assert ran == ["features@Home2"]


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
    result = run(tmp_path, "python", "-m", "placecat.stages.features", "Home2", check=False)
    check_refused(result, "00000003.jpg")
    assert not (tmp_path / "data/features/Home2").exists()
    assert not any((tmp_path / "data/features").glob(".*"))


@pytest.mark.parametrize(
    ("override", "stage", "message"),
    [
        ("cues.gist.classifier.base.nu=1.5", "cues", "nu = 1.5 is outside (0, 1]"),
        (
            "cues.gist.classifier.base={nu_policy: refuse, nu: 0.9}",
            "cues",
            "nu = 0.9 is infeasible for class 'bedroom'",
        ),
        ("cues.hog_y.classifier.clusters=47", "cues", "46"),
        ("cues.hog_y.classifier.clusters=61", "cues", "46"),
        ("cues.hog_y.classifier.base.alfa=1", "cues", "'alfa'"),
        ("codebooks.hog_y.tree.max_clusters=40", "codebooks", "31 "),
    ],
    ids=[
        "impossible nu",
        "infeasible nu",
        "impossible number",
        "more than the codebook has",
        "unknown setting",
        "impossible codebook",
    ],
)
def test_impossible_settings_give_one_message_and_leave_nothing(
    reproduced, tmp_path, override, stage, message
):
    folder, _, _ = reproduced
    (tmp_path / "data").mkdir()
    for part in ("sequences", "features", "codebooks"):
        if part != stage:
            (tmp_path / "data" / part).symlink_to(folder / "data" / part)
    (tmp_path / "params.yaml").write_text(compose([*SMALL, f"++{override}"], conf=ROOT / "conf"))
    item = override.split(".")[1]
    result = run(tmp_path, "python", "-m", f"placecat.stages.{stage}", item, check=False)
    check_refused(result, message)
    assert not any((tmp_path / f"data/{stage}").glob("*"))


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
    """One line that names the thing, no traceback, a status that is not 0."""
    assert result.returncode == 1
    lines = [line for line in result.stderr.splitlines() if line.startswith("placecat: ")]
    assert len(lines) == 1
    assert message in lines[0]
    assert "Traceback" not in result.stderr
