"""Invalid combinations are rejected before anything is computed; messages name valid ones."""

import pytest
from hydra.errors import HydraException
from made_experiments import CONF, SMALL, make_project, resolved, swept

from placecat.errors import PlacecatError
from placecat.experiment import application
from placecat.experiment.data import find_homes

WRONG = (PlacecatError, HydraException)


@pytest.mark.parametrize(
    ("override", "message"),
    [
        ("descriptor=hgo", r"(?s)descriptor/hgo.*centrist.*hog"),
        ("descriptor=sift", "sift of salient regions was not computed .* use one of color_mv, hog"),
        ("descriptor=hog", "max_regions=25, but at most 4 regions"),
        ("descriptor.kind=x", "kind"),
        ("descriptor.max_regions=null", "max_regions is missing: set it to a number for descriptor hog"),
        ("descriptor.y_weight=null", "y_weight is missing"),
        ("descriptor.color=hog", "color=hog appends the descriptor to itself"),
        ("descriptor.y_pos=often", "y_pos=often"),
        ("descriptor.tracked=true", "tracked salient regions was not computed"),
        ("classifier=svm", r"(?s)classifier/svm.*dependency_tree.*knn"),
        ("classifier.clusters=14", "use 13 or 16"),
        ("classifier.base.alhpa=1", "alhpa"),
        ("test_home=H9", "H1, H2, H3, H4"),
        ("data=museum", r"(?s)data/museum.*apartments.*main.*university"),
        ("data=university", "use one of main, site"),
        ("judge=me", "test_home.*training_homes"),
        ("seeds=[0,0]", "seeds="),
        ("frames.offset=3", "offset is 3 and step is 3"),
        ("codebook.cells=3", "use 1"),
        ("tset_home=H1", "tset_home"),
        ("+tset_home=H1", "did you mean 'test_home'"),
        ("+frames.stop=1", "frames has no setting 'stop'"),
        ("seeds=[true]", "seeds"),
    ],
)
def test_an_invalid_setting_is_rejected_with_valid_ones(project, override, message):
    small = [one for one in SMALL if override != "descriptor=hog" or not one.startswith("descriptor.")]
    with pytest.raises(WRONG, match=message):
        resolved(*small, override)


@pytest.mark.parametrize(
    ("overrides", "message"),
    [
        (["classifier=nu_svm", "classifier.clusters=13"], r"classifier\.clusters"),
        (["descriptor.y_pos=true"], r"descriptor\.y_pos"),
        (["classifier=nu_svm", "classifier.reduction={cells: 3, components: 2}"], "cannot be divided into 3"),
        (["classifier=nu_svm", "classifier.reduction={cells: 4, componnts: 2}"], "did you mean 'components'"),
        (["classifier=nu_svm", "codebook.cells=4"], "for classifiers on clusters, not for nu_svm"),
        (["classifier=nu_svm", "classifier.base.nu=2"], r"base\.nu=2: it must be less than or equal to 1"),
        (["codebook.cells=3"], "use one of 1, 2, 4, 8, 16"),
        (["classifier=knn", "codebook.cells=4"], "use 1"),
        (["classifier=knn", "+classifier.reduction={cells: 4}"], "no setting 'reduction'"),
        (["judge=training_homes", "+data=site"], "data"),
    ],
)
def test_incompatible_settings_are_rejected(project, overrides, message):
    with pytest.raises(WRONG, match=message):
        resolved("descriptor=gist", *overrides)


def test_a_kernel_on_many_regions_needs_a_limit(project):
    svm = [SMALL[0], "classifier=nu_svm", "limits.kernel_rows=50"]
    with pytest.raises(PlacecatError, match=r"classifier\.max_rows=1000, .*naive_bayes"):
        resolved(*svm)
    resolved(*svm, "classifier.max_rows=50")
    resolved(SMALL[0], "classifier=gentle_adaboost", "limits.kernel_rows=50")


def test_a_rejected_sweep_lists_all_invalid_combinations(project):
    with pytest.raises(PlacecatError) as caught:
        swept("descriptor=gist", "classifier=nu_svm,naive_bayes", "classifier.clusters=46,47")
    text = str(caught.value)
    assert text.startswith("3 of 4 combinations are invalid; nothing was computed:")
    assert "use 46 or 61\n    classifier=naive_bayes classifier.clusters=47" in text
    assert "classifier=nu_svm classifier.clusters=46" in text
    assert "classifier=naive_bayes classifier.clusters=46" not in text


def test_an_interval_requires_a_search(project):
    with pytest.raises(PlacecatError, match="which only a search allows"):
        swept("descriptor=gist", "classifier=nu_svm", "classifier.base.nu=interval(0.1,0.2)")


@pytest.mark.parametrize(("last", "used"), [("4", [4]), ("13,4", [13, 4])])
def test_the_last_values_of_a_key_are_used(project, last, used):
    """The table does not list values that were not computed."""
    words = ("descriptor=gist", "classifier=knn", SMALL[1], "classifier.clusters=13,16")
    experiments, combinations = swept(*words, "test_home=h1", f"classifier.clusters={last}")
    assert [one.settings["classifier"]["clusters"] for one in experiments] == used
    swept_values = [{"classifier.clusters": str(one)} for one in used]
    assert combinations == (swept_values if len(used) > 1 else [{}])


def test_combinations_are_in_the_order_of_hydra(project):
    experiments, combinations = swept(
        "descriptor=gist", "classifier=knn,naive_bayes", "classifier.clusters=16,46", "track=false"
    )
    assert [tuple(one.items()) for one in combinations] == [
        (("classifier", "knn"), ("classifier.clusters", "16")),
        (("classifier", "knn"), ("classifier.clusters", "46")),
        (("classifier", "naive_bayes"), ("classifier.clusters", "16")),
        (("classifier", "naive_bayes"), ("classifier.clusters", "46")),
    ]
    assert [one.settings["classifier"]["clusters"] for one in experiments] == [16, 46, 16, 46]


@pytest.mark.parametrize("path", sorted((CONF / "classifier").glob("*.yaml")), ids=lambda path: path.stem)
def test_every_classifier_accepts_whole_frames_or_is_rejected(project, path):
    if path.stem == "discriminative_regions":
        with pytest.raises(PlacecatError, match="needs salient regions, but descriptor gist describes whole"):
            resolved("descriptor=gist", f"classifier={path.stem}", "test_home=all")
        return
    experiment = resolved("descriptor=gist", f"classifier={path.stem}", "test_home=all")
    on_clusters = "clusters" in experiment.settings["classifier"]
    assert experiment.seeds == ((0, 1) if on_clusters else (None,))
    cells = 1 if path.stem == "knn" else 16
    assert experiment.settings.get("codebook", {}).get("cells") == (cells if on_clusters else None)


def test_a_home_may_be_spelled_in_any_way(project):
    data = resolved("descriptor=gist").data
    for spelling in ("H1", "h1", "h_1", "H-1", ["h 1"]):
        assert find_homes(data, spelling) == ("H1",)
    assert find_homes(data, "all") == ("H1", "H2", "H3", "H4")
    with pytest.raises(PlacecatError, match="H1 twice"):
        find_homes(data, ["h1", "H1"])


def test_a_training_set_that_lacks_a_place_is_rejected(tmp_path, monkeypatch):
    folder = make_project(tmp_path / "project")
    for home in ("H2", "H3", "H4"):
        path = folder / f"data/sequences/{home}/labels.csv"
        path.write_text(path.read_text().replace(",2", ",-1"))
    monkeypatch.chdir(folder)
    with pytest.raises(PlacecatError, match="on H1 needs training frames of bathroom, but H2, H3, H4 have"):
        resolved("descriptor=gist", "test_home=H1")


def test_a_wrong_folder_and_missing_features_are_reported(tmp_path, monkeypatch, made_project):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(PlacecatError, match="run this in the project folder"):
        application.main([])
    (tmp_path / "conf").symlink_to(CONF)
    (tmp_path / "params.yaml").write_text((made_project / "params.yaml").read_text())
    with pytest.raises(PlacecatError, match="missing: run `dvc repro`"):
        resolved()
