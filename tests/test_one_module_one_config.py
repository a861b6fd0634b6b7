"""A cue needs only one module and one file in conf/cue, as shown in a copy of the project with real DVC."""

import shutil

import numpy as np
import pytest

from placecat import settings
from placecat.training import fold_file
from project import HOMES, ROOT, SITES, SMALL, commit, contents, init, repro, run
from sketch import draw_homes
from test_adding import BLOCKS

pytestmark = [pytest.mark.slow, pytest.mark.xdist_group("one_cue")]

HOME_NAMES = ["Home1", "Home2", "Home3", "Home4"]
LOCAL_MODULE = '''"""Thumbnail: the mean intensity in the cells of a region."""

import numpy as np
from numpy.typing import NDArray

from placecat.vision.grid import cell_means
from placecat.vision.maps import FrameMaps
from placecat.vision.patches import cut, region_side

# The fixed unit of `concatenate`.
SPREAD = 200.0
# The fields of `FrameMaps` that it reads.
MAPS = ("grey",)


def size(*, cells: int = 2) -> int:
    """Length of the descriptor: cells x cells."""
    return cells * cells


def describe(
    maps: FrameMaps, regions: NDArray[np.float32], *, cells: int = 2, border: str = "replicate"
) -> NDArray[np.float32]:
    """Describe n regions by (n, cells x cells) mean intensities, row by row, 0 to 255."""
    patches = cut(maps.grey, regions, region_side(maps.width), border=border)
    return cell_means(patches, cells).reshape(len(regions), size(cells=cells))
'''
LOCAL_CUE = """defaults:
- /classifier@classifier: naive_bayes
- _self_

title: Thumbnail + y-Pos
codebook: thumbnail_y
schemes: [5-5-1]
cross_validate: false
extra: false
descriptor:
  kind: local
  name: thumbnail
  y_pos: true
  y_weight: 1.0
  color: null
  max_regions: 25
classifier:
  clusters: 16
"""
# The cue from docs/adding.md and its classifier.
FOLLOWED = {
    name: text
    for name, text in BLOCKS.items()
    if ("brightness" in name and "tables" not in name) or "nearest_mean" in name
}
ADDED = {
    **FOLLOWED,
    "src/placecat/vision/local/thumbnail.py": LOCAL_MODULE,
    "conf/cue/thumbnail_y.yaml": LOCAL_CUE,
}
SETTINGS = [
    *SMALL,
    *(f"splits.{split}.dataset.homes=[Home1]" for split in SITES),
    "protocol.test_homes=[Home1]",
    "protocol.seeds=[0]",
]


def own(folder, *command, check=True):
    """Run a command with the package of the copy, not the installed one."""
    # One worker is faster than two if there is little work.
    return run(folder, *command, check=check, PYTHONPATH=str(folder / "src"), PLACECAT_WORKERS="1")


@pytest.fixture(scope="module")
def before(tmp_path_factory):
    """A copy of the project with small homes in git; one home has features."""
    folder = tmp_path_factory.mktemp("project")
    shutil.copytree(ROOT / "src", folder / "src", ignore=shutil.ignore_patterns("__pycache__", "*.egg-info"))
    shutil.copytree(ROOT / "conf", folder / "conf")
    for name in ("dvc.yaml", ".dvcignore", ".gitignore"):
        shutil.copy(ROOT / name, folder / name)
    draw_homes(folder / HOMES, homes=len(HOME_NAMES), frames_per_room=4, width=320, height=180)
    for root in SITES.values():
        draw_homes(folder / root, homes=1, frames_per_room=2, width=320, height=180)
    own(folder, "python", "-m", "placecat", "params", *SETTINGS)
    init(folder)
    own(folder, "dvc", "repro", "features")
    commit(folder)
    return folder


@pytest.fixture(scope="module")
def after(before, tmp_path_factory):
    """The copy with two additional cues, its earlier features, and the stages that ran."""
    features = contents(before, "data/features/Home1")
    for name, text in ADDED.items():
        (before / name).write_text(text)
    own(before, "python", "-m", "placecat", "params", *SETTINGS)
    ran, _ = repro(before, "cues", PYTHONPATH=str(before / "src"), PLACECAT_WORKERS="1")
    return before, features, ran


def test_one_module_and_one_file_make_a_cue(after):
    folder, _, ran = after
    assert {"features", "codebooks", "cues"} <= set(ran)
    for cue in ("brightness", "thumbnail_y"):
        tests = sorted((folder / "data/cues" / cue / "5-5-1").glob("*.npz"))
        assert {path.name.split(".")[0] for path in tests} == {"Home1"}
        for path in tests:
            proba = fold_file.read(path, "test")
            assert proba.shape[1] == 5
            assert (proba >= 0).all()
            np.testing.assert_allclose(proba.sum(axis=1), 1)
            assert len(np.unique(proba.round(6), axis=0)) > 1


def test_nothing_else_changes_in_git(after):
    folder, _, _ = after
    lines = run(folder, "git", "status", "--porcelain", "--untracked-files=all").stdout.splitlines()
    written = ["conf/found.yaml", "dvc.lock", "params.yaml"]
    assert sorted(lines) == sorted([*(f" M {name}" for name in written), *(f"?? {name}" for name in ADDED)])


def test_existing_descriptors_keep_their_bytes(after):
    folder, features, _ = after
    now = contents(folder, "data/features/Home1")
    place = "data/features/Home1"
    assert set(now) - set(features) == {f"{place}/holistic_brightness.npy", f"{place}/local_thumbnail.npy"}
    # Only the lists of modules and files have changed.
    changed = {name for name in features if now[name] != features[name]}
    lists = {name for name in features if name.endswith("/descriptors.json")}
    assert changed == lists | {f"{place}/manifest.json"}
    assert f"{place}/descriptors.json" in lists


def test_settings_are_the_defaults_of_the_module_and_of_the_clustering(after):
    folder, _, _ = after
    params = settings.load(folder / "params.yaml")
    assert params["descriptors"]["holistic"]["brightness"] == {"cells": 4}
    assert params["descriptors"]["local"]["thumbnail"] == {"cells": 2, "border": "replicate"}
    like = params["codebooks"]["centrist_y"]
    like["descriptor"]["name"], like["schemes"] = "thumbnail", ["5-5-1"]
    like["tree"]["max_clusters"] = params["codebooks"]["thumbnail_y"]["tree"]["max_clusters"]
    assert params["codebooks"]["thumbnail_y"] == like


def test_the_descriptor_tests_include_new_descriptors(after):
    folder, _, _ = after
    files = [ROOT / f"tests/vision/{kind}/test_{kind}_descriptors.py" for kind in ("holistic", "local")]
    command = ("pytest", "-v", "-p", "no:cacheprovider", "-k", "brightness or thumbnail", *files)
    lines = own(folder, *command).stdout.splitlines()
    for kind, name in (("holistic", "brightness"), ("local", "thumbnail")):
        test = f"test_{kind}_descriptors.py::test_deterministic_and_free_of_side_effects[{name}] PASSED"
        assert any(test in line for line in lines)
