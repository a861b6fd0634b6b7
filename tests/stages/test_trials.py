"""The stages `trials` and `splits` on generated features: their outputs, and no leak of test data."""

import numpy as np
import pandas as pd
import pytest
from made_features import CLASSES, HOMES, PARAMS, STUDIES, make, ran_once

from placecat import cues
from placecat.evaluation.accuracy import confusion_matrix
from placecat.results.measured import from_scores
from placecat.stages import splits, trials
from placecat.training import fold_file

TREE = "trials/table_01/||"


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return ran_once(tmp_path_factory)


def tables(folder):
    return [pd.read_csv(folder / f"data/trials/some/{name}.csv") for name in ("scores", "missing")]


def test_trials_have_counts_for_their_homes_and_seeds(folder):
    results = from_scores(*tables(folder), HOMES, CLASSES)
    assert set(results.measured) == {f"{TREE}4", f"{TREE}13", "trials/table_02/|PCA|"}
    clustered, fixed = results.of(f"{TREE}4"), results.of("trials/table_02/|PCA|")
    # The table needs homes 1, 3 and 9; the data set lacks one of them.
    assert (clustered.homes, clustered.seeds) == (("H1", "H3"), ("seed-0", "seed-1"))
    assert (fixed.homes, fixed.seeds) == (tuple(HOMES), ("no-seed",))
    labels = pd.read_csv(folder / "data/sequences/H3/labels.csv")["class"]
    assert clustered.confusion.sum(axis=(2, 3)).tolist()[0][1] == (labels >= 0).sum()
    assert not np.array_equal(clustered.confusion[0], clustered.confusion[1])


def test_invalid_trials_have_a_reason(folder):
    _, missing = tables(folder)
    assert missing["result"].unique().tolist() == [f"{TREE}400"]
    assert missing["home"].tolist() == ["H1", "H3"]
    assert missing["reason"].str.startswith("400 clusters cannot be formed").all()


def test_a_trial_and_a_cue_with_the_same_settings_agree(folder):
    """The PCA trial equals the cue `gist`: both are a nu-SVM on reduced Gist in the 5-5-1 scheme."""
    results = from_scores(*tables(folder), HOMES, CLASSES)
    for number, home in enumerate(HOMES):
        proba = fold_file.read(folder / f"data/cues/gist/5-5-1/{home}.no-seed.npz", "test")
        labels = pd.read_csv(folder / f"data/sequences/{home}/labels.csv")["class"]
        expected = confusion_matrix(labels, proba.argmax(axis=1), len(CLASSES))
        np.testing.assert_array_equal(results.of("trials/table_02/|PCA|").confusion[0, number], expected)


def mark_unscored(folder, features, sequences):
    """Plant a marker in the unscored frames of a test home."""
    labels = pd.read_csv(folder / sequences / "labels.csv")["class"].to_numpy()
    for path in (folder / features).glob("*.npy"):
        array = np.load(path)
        if array.dtype == np.float32:
            array[labels < 0] += 100
            np.save(path, array)
    return labels >= 0


def run_here(stage, folder, monkeypatch):
    """Run one stage that does not depend on the others in `run_stages`."""
    monkeypatch.chdir(folder)
    monkeypatch.setenv("PLACECAT_WORKERS", "1")
    stage.main()


def test_no_trial_learns_from_its_test_home(folder, tmp_path, monkeypatch):
    make(tmp_path)
    mark_unscored(tmp_path, "data/features/H3", "data/sequences/H3")
    run_here(trials, tmp_path, monkeypatch)
    plain, marked = tables(folder)[0], tables(tmp_path)[0]
    pd.testing.assert_frame_equal(*(one[one["home"] == "H3"].reset_index() for one in (plain, marked)))
    # When H3 is used for training, its unscored frames do not matter either.
    pd.testing.assert_frame_equal(plain, marked)


def test_no_split_learns_from_its_test_sequence(folder, tmp_path, monkeypatch):
    make(tmp_path)
    scored = mark_unscored(tmp_path, "data/site_features/site/robot", "data/site_sequences/site/robot")
    run_here(splits, tmp_path, monkeypatch)
    files = list((folder / "data/splits").rglob("*.npz"))
    assert len(files) == 5
    pairs = [
        (fold_file.read(path, "test"), fold_file.read(tmp_path / path.relative_to(folder), "test"))
        for path in files
    ]
    for plain, marked in pairs:
        np.testing.assert_array_equal(plain[scored], marked[scored])
    assert any(not np.array_equal(plain, marked) for plain, marked in pairs)


def test_extra_data_change_the_training_of_the_integration(folder):
    system = PARAMS["systems"]["vote"]
    assert system["extra"]
    with_extra = fold_file.read(folder / "data/integration/vote/H1.seed-0.npz", "cross_validated_truth")
    without = fold_file.read(folder / "data/integration/das/H1.seed-0.npz", "cross_validated_truth")
    labels = pd.read_csv(folder / "data/site_sequences/site/flip/labels.csv")["class"].to_numpy()
    # The site has kitchen, office, bedroom and bathroom; classes are matched by name, and the office has
    # none.
    taken = labels[1::3]
    expected = np.array([1, -1, 0, 2, -1])[taken]
    np.testing.assert_array_equal(with_extra, np.concatenate([without, expected[expected >= 0]]))


def test_filtered_frames_repeat_the_last_accepted_decision(folder):
    information = np.load(folder / "data/features/H1/information.npy")
    plain = fold_file.read(folder / "data/cues/gist/5-5-1/H1.no-seed.npz", "test")
    held = fold_file.read(folder / "data/filtered/informative/gist/H1.no-seed.npz", "test")
    rejected = np.flatnonzero(information < 0.3)
    rejected = rejected[(rejected > 0) & (rejected != 50)]
    assert len(rejected) > 10
    np.testing.assert_array_equal(held[information >= 0.3], plain[information >= 0.3])
    np.testing.assert_array_equal(held[rejected], held[rejected - 1])


def fitted_on(monkeypatch, call):
    """Return the training inputs of a cue as bytes: descriptors, labels, homes and clusters."""
    seen = []
    fit = cues.fit

    def recorded(train, labels, homes, *, codebook=None, **options):
        clusters = [] if codebook is None else [array.tobytes() for array in codebook.to_arrays().values()]
        seen.append((train.x.tobytes(), labels.tobytes(), homes.tobytes(), *clusters))
        return fit(train, labels, homes, codebook=codebook, **options)

    with monkeypatch.context() as patch:
        patch.setattr(cues, "fit", recorded)
        call()
    return seen


@pytest.mark.parametrize(("test_home", "differs"), [("H3", False), ("H1", True)])
def test_a_marker_in_the_test_home_does_not_leak_into_a_trial(tmp_path, monkeypatch, test_home, differs):
    """Labelled frames are marked, too. If the marked home is used for training, the marker has an effect."""
    from placecat.training.plan import of_homes
    from placecat.training.trial import judge, of_settings

    table = STUDIES["some"]["table_01"]["trial"]
    (plan,) = of_homes(PARAMS, "5-5-1", test_home)
    found = []
    for name, marked in (("plain", None), ("marked", "H3")):
        (tmp_path / name).mkdir()
        make(tmp_path / name, marked=marked)
        monkeypatch.chdir(tmp_path / name)
        found.append(fitted_on(monkeypatch, lambda: judge(plan, [of_settings(table)], 0)))
    assert len(found[0]) == 1
    assert (found[0] != found[1]) is differs


@pytest.mark.parametrize(("marked", "differs"), [("robot", False), ("flip", True)])
def test_a_marker_in_the_test_sequence_does_not_leak_into_a_split(tmp_path, monkeypatch, marked, differs):
    monkeypatch.setenv("PLACECAT_WORKERS", "1")
    found = []
    for name, home in (("plain", None), ("marked", marked)):
        (tmp_path / name).mkdir()
        make(tmp_path / name, marked=home)
        monkeypatch.chdir(tmp_path / name)
        found.append(fitted_on(monkeypatch, splits.main))
    assert len(found[0]) >= 3
    assert (found[0] != found[1]) is differs
