"""The test home does not leak into training: marking it leaves the bytes of all fitted parts unchanged."""

import numpy as np
import pytest
from made_features import HOMES, PARAMS, make, ran_once, run_stages

from placecat import files

MARKED = "H2"

pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def runs(tmp_path_factory):
    folders = {"plain": ran_once(tmp_path_factory), "marked": tmp_path_factory.mktemp("marked")}
    with pytest.MonkeyPatch.context() as patch:
        make(folders["marked"], marked=MARKED)
        run_stages(folders["marked"], patch)
    return folders


# Model outputs for the test home, which may change with its frames.
APPLIED = ("test", "tempered")


def fitted_files(folder, home):
    """Return all parts fitted with `home` as the test home, and their outputs for training frames."""
    kinds = (f"codebooks/*/without-{home}*.npz", f"cues/*/*/{home}.*.npz", f"integration/*/{home}.*.npz")
    found = {}
    for path in (path for kind in kinds for path in folder.glob(f"data/{kind}")):
        place = path.relative_to(folder)
        for name, array in files.read_arrays(path).items():
            if name not in APPLIED:
                found[place, name] = array.tobytes()
        if path.with_suffix(".json").exists():
            found[place, "facts"] = path.with_suffix(".json").read_bytes()
    return found


def test_parts_fitted_for_the_marked_home_do_not_change(runs):
    plain, marked = fitted_files(runs["plain"], MARKED), fitted_files(runs["marked"], MARKED)
    assert len(plain) > 30
    assert plain.keys() == marked.keys()
    assert [str(name) for name in plain if plain[name] != marked[name]] == []


def test_the_marker_changes_the_fitted_parts_when_used_for_training(runs):
    """If another home is tested, the marked home is used for training, and the same files change."""
    other = next(home for home in HOMES if home != MARKED)
    plain, marked = fitted_files(runs["plain"], other), fitted_files(runs["marked"], other)
    changed = {name[0].parts[1] for name in plain if plain[name] != marked[name]}
    assert changed == {"codebooks", "cues", "integration"}


def test_the_transitions_do_not_come_from_the_test_home(runs, monkeypatch):
    """With the same distributions, the labels of the test home must not matter."""
    from placecat.training.plan import of_homes
    from placecat.training.saved import smooth_home

    model = {
        "delay_seconds": 1.0,
        "evidence": "soft",
        "evidence_seconds": 1.0,
        "reliability": "hard",
        "transition_counts": 1.0,
        "emission_counts": 1.0,
    }
    (plan,) = of_homes(PARAMS, "5-5-1", MARKED)
    source = runs["plain"] / f"data/integration/das/{MARKED}.seed-1.npz"
    results = []
    for name in ("plain", "marked"):
        monkeypatch.chdir(runs[name])
        results.append(smooth_home(source, plan, model)["delayed"])
    np.testing.assert_array_equal(*results)


def test_results_do_not_depend_on_the_number_of_workers(runs, tmp_path, monkeypatch, two_workers):
    from placecat.stages import codebooks, cues

    make(tmp_path)
    monkeypatch.chdir(tmp_path)
    codebooks.main()
    cues.main()
    for path in sorted(tmp_path.glob("data/c*/*/**/*.n*")):
        assert path.read_bytes() == (runs["plain"] / path.relative_to(tmp_path)).read_bytes(), path


def test_distributions_are_valid(runs):
    found = [
        (path, array)
        for kind in ("cues", "integration", "filtered", "smoothing", "splits")
        for path in runs["plain"].glob(f"data/{kind}/**/*.npz")
        for name, array in files.read_arrays(path).items()
        if name in ("test", "hmm", "delayed")
    ]
    assert len(found) > 80
    for path, proba in found:
        assert proba.shape == (90, 4 if "splits" in path.parts else 3)
        np.testing.assert_allclose(proba.sum(axis=1), 1.0, atol=1e-9)
        assert (proba >= 0).all()
