"""Run `placecat params` and the stages up to smoothing on a small Robot@Home2 database."""

import numpy as np
import pytest
import yaml
from made_robot_at_home import HOMES, make

from placecat import paths, settings
from placecat.__main__ import main
from placecat.config import tables as checks
from placecat.config.check import check
from placecat.config.compose import compose
from placecat.sequences import listing
from placecat.settings import Loader
from placecat.stages import cues, features, integration, sequences, smoothing
from placecat.training import fold_file
from project import ROOT, light_conf

WIDTH, HEIGHT = 120, 160
# Direction of the stripes, in degrees, for each room type that is a class.
STRIPES = {"bedroom": 0, "masterroom": 0, "bathroom": 45, "kitchen": 90, "livingroom": 135}
# The test is quick, because no cue uses regions.
CUES, SYSTEM = ("gist", "spatial_pact"), "das_551_best"


def picture(home, room, number):
    """Draw stripes in the direction of the class, or noise if the room has no class."""
    rng = np.random.default_rng([*f"{home} {room}".encode(), number])
    y, x = np.mgrid[:HEIGHT, :WIDTH]
    direction = STRIPES.get(room[:-1])
    waves = 0.0
    if direction is not None:
        angle, length, shift = (
            np.deg2rad(direction + rng.uniform(-8, 8)),
            rng.uniform(9, 15),
            rng.uniform(0, 7),
        )
        waves = 50 * np.sin((x * np.cos(angle) + y * np.sin(angle)) * 2 * np.pi / length + shift)
    gray = 128 + waves + rng.normal(0, 15, (HEIGHT, WIDTH))
    return np.repeat(gray.clip(0, 255).astype(np.uint8)[..., None], 3, axis=2)


@pytest.fixture(scope="module")
def ran(tmp_path_factory):
    """Run the stages that need no codebooks, and yield the settings."""
    folder = tmp_path_factory.mktemp("robot_at_home")
    conf = light_conf(folder / "conf")
    kept = {"cue": CUES, "system": (SYSTEM,), "descriptor/local": ("color_mv",)}
    for group in ("codebook", "cue", "descriptor/local", "filter", "split", "system"):
        for path in (conf / group).glob("*.yaml"):
            if path.stem not in kept.get(group, ()):
                path.unlink()
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(folder)
        patch.setenv("PLACECAT_WORKERS", "1")
        make(folder / "Robot@Home2", picture, cameras=[1], frames=5)
        few = [
            f"systems.{SYSTEM}.cues=[{','.join(CUES)}]",
            "cues.spatial_pact.classifier.reduction.components=4",
            f"model.system={SYSTEM}",
            *(f"cues.{cue}.{own}=false" for cue in CUES for own in ("extra", "cross_validate")),
            *(f"cues.{cue}.schemes=[5-5-1]" for cue in CUES),
            *("protocol.extra=null", "region_variants.descriptors=[]", "region_variants.variants={}"),
            *("smoothing.cues=[]", "smoothing.filtered=[]", "tracking.descriptors=[]"),
        ]
        main(["params", "dataset=robot_at_home", "dataset.root=Robot@Home2", *few])
        for stage in (sequences, features, cues, integration, smoothing):
            stage.main()
        yield settings.load()


@pytest.mark.slow
def test_every_home_is_left_out_and_most_decisions_are_correct(ran):
    assert ran["dataset"]["classes"] == ["bedroom", "bathroom", "kitchen", "living_room"]
    for home in HOMES:
        truth = listing.read_labels(home)
        (seed,) = fold_file.seeds_in(paths.SMOOTHING / SYSTEM, home)
        single = fold_file.read(fold_file.path_of(paths.INTEGRATION / SYSTEM, home, seed), "test")
        smoothed = fold_file.read(fold_file.path_of(paths.SMOOTHING / SYSTEM, home, seed), "delayed")
        for proba in (single, smoothed):
            assert proba.shape == (len(truth), 4)
            np.testing.assert_allclose(proba.sum(axis=1), 1)
        # Chance is 25%. If frames were mixed up with labels or files of other frames, few would be correct.
        assert (single.argmax(axis=1) == truth)[truth >= 0].mean() > 0.7, home


def test_the_settings_need_no_overrides(monkeypatch):
    """The settings of the project are valid without further overrides."""
    monkeypatch.chdir(ROOT)
    params = yaml.load(compose(["dataset=robot_at_home", "dataset.root=/data/rah"]), Loader=Loader)
    check(params)
    checks.check(params)
    assert (params["dataset"]["camera"], params["dataset"]["turn"]) == ("RGBD_1", 0)
