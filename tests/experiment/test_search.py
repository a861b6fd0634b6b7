"""Searches: an artificial objective without Hydra's launcher, and the real application on random features."""

import csv
import itertools
import os
import subprocess
import sys

import numpy as np
import pytest
import yaml
from hypothesis import given, settings
from hypothesis import strategies as st
from made_experiments import CONF, make_project
from omegaconf import OmegaConf

from placecat.errors import PlacecatError
from placecat.learning.hierarchical_kmeans import check_cluster_number
from placecat.learning.scaling import KINDS
from placecat.search import report, space, study

pytest.importorskip("optuna")
pytestmark = [pytest.mark.slow, pytest.mark.xdist_group("experiment")]

GAMMA, SCALING, CLUSTERS = "classifier.base.gamma", "classifier.scaling", "classifier.clusters"
PARAMS = {GAMMA: "tag(log, interval(0.02, 20.0))", SCALING: "choice(none, standard)"}


def config(**changed):
    own = {
        "hydra": {"runtime": {"choices": {"descriptor": "hog", "classifier": "nu_svm", "data": "main"}}},
        "descriptor": {"kind": "local", "name": "hog", "y_pos": True, "tracked": False},
        "classifier": {
            "model": "one_against_all",
            "base": {"name": "nu_svm", "gamma": 2.0},
            "scaling": "standard",
            "clusters": 91,
        },
        "test_home": "home_1",
        "judge": "training_homes",
    }
    return OmegaConf.create(own | changed)


def read(params=PARAMS, arguments=(), cues=None, **changed):
    return space.read(params, arguments, config(**changed), {"cues": cues or {}, "codebooks": {}}, digits=3)


def cue(**descriptor):
    classifier = {"model": "one_against_all", "base": {"name": "nu_svm", "gamma": 1.5}, "scaling": "none"}
    return {"descriptor": {"kind": "local", "name": "hog"} | descriptor, "classifier": classifier}


def search(own, objective, **changed):
    numbers = {"n_trials": 12, "batch_size": 4, "seed": 0, "n_startup_trials": 4}
    return study.search(own, lambda lines, first: [objective(one) for one in lines], **numbers | changed)


@settings(max_examples=25, deadline=None)
@given(
    values=st.lists(st.one_of(st.floats(0, 100), st.just(float("nan"))), min_size=12, max_size=12),
    first=st.lists(st.floats(0, 100), min_size=2, max_size=2),
    batch_size=st.integers(1, 5),
    seed=st.integers(0, 2**32 - 1),
)
def test_the_result_is_at_least_as_good_as_every_start(values, first, batch_size, seed):
    own = read(cues={"hog_y": cue(y_pos=True)})
    accuracies = iter([*first, *values])
    tried = search(own, lambda one: next(accuracies), batch_size=batch_size, seed=seed)
    assert [one.accuracy for one in tried[:2]] == first
    assert tried[0].overrides == (f"{GAMMA}=2.0", f"{SCALING}=standard")
    assert tried[1].overrides == (f"{GAMMA}=1.5", f"{SCALING}=none")
    assert study.best(tried).accuracy >= max(first)
    assert study.best(tried).accuracy == max(one.accuracy for one in tried if one.accuracy is not None)


def test_choices_are_within_the_space_and_not_run_twice():
    batches = []

    def run(lines, first):
        batches.append((first, len(lines)))
        return [float(one[0].split("=")[1]) for one in lines]

    own = read({CLUSTERS: "range(46, 107, 15)"})
    tried = study.search(own, run, n_trials=30, batch_size=4, seed=1, n_startup_trials=4)
    chosen = [one.overrides[0] for one in tried]
    assert len(set(chosen)) == len(chosen)
    assert set(chosen) <= {f"{CLUSTERS}={number}" for number in (46, 61, 76, 91, 106)}
    assert study.best(tried).overrides == (f"{CLUSTERS}=106",)
    counts = [count for _, count in batches]
    assert [first for first, _ in batches] == list(itertools.accumulate([0, *counts[:-1]]))


def test_later_trials_are_better():
    # The maximum is at gamma = 0.1, far from the start.
    import math

    def objective(one):
        return 100 - abs(math.log10(float(one[0].split("=")[1])) + 1)

    tried = search(read({GAMMA: PARAMS[GAMMA]}), objective, n_trials=24)
    first, last = tried[:8], tried[-8:]
    assert sum(one.accuracy for one in last) > sum(one.accuracy for one in first)
    assert study.best(tried).accuracy > 99.8
    assert search(read({GAMMA: PARAMS[GAMMA]}), objective, n_trials=24) == tried
    assert search(read({GAMMA: PARAMS[GAMMA]}), objective, n_trials=24, seed=1) != tried


def test_a_search_without_any_accuracy_ends_early():
    asked = []
    with pytest.raises(PlacecatError, match="none of the first 4 experiments"):
        search(read(), lambda one: asked.append(one) or float("nan"))
    assert len(asked) == 4


def test_a_start_without_an_accuracy_is_reported(tmp_path):
    own = read()
    tried = search(own, lambda one: float("nan") if one[0].endswith("=2.0") else 40.0)
    assert tried[0].accuracy is None
    assert study.best(tried).number == 1
    text = report.write(tmp_path, tried, own, {"descriptor": "hog"}, "H1")
    assert f"| {space.SETTINGS} | 0 | - |" in text
    assert "For comparison" not in text


def test_a_cue_with_another_descriptor_is_not_a_start():
    tracked = cue(y_pos=True, tracked=True)
    own = read(cues={"sift_y": cue(name="sift"), "hog": cue(y_pos=False), "hog_tracked": tracked})
    assert list(own.starts) == [space.SETTINGS]


def test_the_thesis_setting_of_hog_is_a_start():
    from placecat import settings as of_project

    params = of_project.load(CONF.parent / "params.yaml")
    own = {
        "descriptor": params["codebooks"]["hog_y"]["descriptor"] | {"tracked": False},
        "classifier": {"model": "joint_probability", "base": {"name": "naive_bayes"}, "clusters": 91},
    }
    found = space.find_starts([CLUSTERS], config(**own), params)
    assert found == {space.SETTINGS: {CLUSTERS: 91}, "conf/cue/hog_y.yaml": {CLUSTERS: 196}}


def test_the_command_line_takes_precedence():
    own = read(arguments=[f"{GAMMA}=1.0", "test_home=home_1", f"{SCALING}=choice(standard,unit)"])
    assert list(own.distributions) == [SCALING]
    assert own.distributions[SCALING].choices == ("standard", "unit")
    assert own.fixed == (f"{GAMMA}=1.0", "test_home=home_1")


@pytest.mark.parametrize(
    ("params", "arguments", "message"),
    [
        ({GAMMA: "interval(3.0, 4.0)"}, (), "does not contain 2.0"),
        ({SCALING: "choice(none, unit)"}, (), "does not contain standard"),
        ({CLUSTERS: "range(16, 91, 15)"}, (), "does not contain 91"),
        ({GAMMA: "tag(log, interval(0.0, 4.0))"}, (), "is not a valid span"),
        ({"classifier.unheard": "choice(1, 2)"}, (), "no such setting"),
        (PARAMS, ["test_home=home_1,home_2"], "belongs to the measurement"),
        (PARAMS, ["judge=choice(training_homes,test_home)"], "belongs to the measurement"),
        (PARAMS, ["seeds=choice([0],[1])"], "belongs to the measurement"),
        ({GAMMA: "2.0"}, (), "nothing to search"),
    ],
)
def test_invalid_spaces_are_rejected(params, arguments, message):
    with pytest.raises(PlacecatError, match=message):
        read(params, arguments)


@pytest.mark.parametrize(
    ("changed", "message"),
    [
        ({"judge": "test_home"}, "judged on training homes only"),
        ({"test_home": "all"}, "would use every home"),
        ({"test_home": ["home_1", "home_2"]}, "would use every home"),
    ],
)
def test_searches_that_use_the_test_home_are_rejected(changed, message):
    with pytest.raises(PlacecatError, match=message):
        space.check(config(**changed))
    space.check(config())


def test_spaces_in_conf_reach_every_valid_value():
    choices = yaml.safe_load((CONF / "search/nu_svm.yaml").read_text())["hydra"]["sweeper"]["params"][SCALING]
    assert choices == f"choice({', '.join(KINDS)})"
    tree = yaml.safe_load((CONF / "clustering/hierarchical_kmeans.yaml").read_text())
    for name in ("knn", "naive_bayes", "dependency_tree"):
        own = yaml.safe_load((CONF / f"search/{name}.yaml").read_text())["hydra"]["sweeper"]["params"]
        (dimension,) = read(own).distributions.values()
        numbers = range(dimension.low, dimension.high + 1, dimension.step)
        assert max(numbers) == tree["max_clusters"]
        for number in numbers:
            check_cluster_number(number, tree["branching"])


def test_the_commands_test_the_best_and_the_first_settings(tmp_path):
    own = read(arguments=["+search=nu_svm", "descriptor=hog", "test_home=Home 1", "codebook.cells=1"])
    tried = search(own, lambda one: 50 + ("none" in one[1]))
    text = report.write(tmp_path, tried, own, {"descriptor": "hog", "data": "main"}, "Home 1")
    assert text == (tmp_path / report.SUMMARY).read_text()
    commands = [line.strip() for line in text.splitlines() if line.startswith("    placecat")]
    program = "placecat experiment descriptor=hog codebook.cells=1 "
    end = " 'test_home=Home 1' judge=test_home"
    found = study.best(tried)
    assert commands == [program + " ".join(one.overrides) + end for one in (found, tried[0])]
    start, *_, reached = accuracies(text)
    assert reached == 51 > start == 50
    assert f"{SCALING}=none" in found.overrides


def accuracies(text):
    """Return the accuracies in the summary of a search: those of the starts, then the highest."""
    rows = [line.split("|") for line in text.splitlines() if line.count("|") == 5]
    return [float(row[3]) for row in rows[2:]]


def run(folder, *arguments, **environment):
    own = {"PLACECAT_WORKERS": "2", "MLFLOW_DISABLE_TELEMETRY": "true"}
    return subprocess.run(
        [sys.executable, "-m", "placecat", "search", "nu_svm", "descriptor=gist", *arguments],
        cwd=folder,
        env=os.environ | own | environment,
        capture_output=True,
        text=True,
        check=False,
    )


def test_the_result_does_not_depend_on_workers_or_test_home(tmp_path):
    folder = make_project(tmp_path / "project")
    found = {}
    for workers in (1, 2):
        for path in (folder / "data/features/H1").glob("*.npy") if workers == 2 else ():
            features = np.load(path)
            np.save(path, np.flip(features, axis=0))
        result = run(
            folder,
            "test_home=H1",
            "track=false",
            "hydra.sweeper.n_trials=3",
            "hydra.sweeper.batch_size=2",
            f"hydra.launcher.n_jobs={workers}",
            f"hydra.sweep.dir=swept_{workers}",
        )
        assert result.returncode == 0, result.stderr
        swept = folder / f"swept_{workers}"
        found[workers] = [(swept / name).read_text() for name in (report.SUMMARY, "summary.csv")]
    assert found[1] == found[2]
    start, *_, reached = accuracies(found[1][0])
    with (folder / "swept_1/summary.csv").open(newline="") as table:
        rows = list(csv.DictReader(table))
    assert [rows[0][key] for key in (GAMMA, SCALING)] == ["2.0", "standard"]
    assert reached >= start
    assert reached == max(float(row["accuracy"]) for row in rows)


def test_without_optuna_one_message_names_the_extra(tmp_path):
    folder = make_project(tmp_path / "project")
    (tmp_path / "hidden").mkdir()
    # Python runs this file when it starts.
    (tmp_path / "hidden/sitecustomize.py").write_text(
        "import importlib.util as u\nreal = u.find_spec\n"
        "u.find_spec = lambda name, *rest: None if name == 'optuna' else real(name, *rest)\n"
    )
    path = os.pathsep.join([str(tmp_path / "hidden"), os.environ.get("PYTHONPATH", "")])
    result = run(folder, "test_home=H1", "track=false", PYTHONPATH=path)
    assert result.returncode == 1
    assert "pip install -e .[search]" in result.stderr
    assert "Traceback" not in result.stderr
    assert len(result.stderr.strip().splitlines()) == 1
