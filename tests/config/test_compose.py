import shutil

import pytest
import yaml
from changed_settings import PARAMS, ROOT, changed, refused

from placecat import lookup
from placecat.config.compose import compose, found, write_params
from placecat.errors import PlacecatError
from placecat.schema import references
from placecat.settings import Loader
from project import light_conf

CONF = ROOT / "conf"


@pytest.fixture(scope="module")
def composed(tmp_path_factory):
    conf = light_conf(tmp_path_factory.mktemp("light") / "conf")
    # One cue is enough here, and composing takes only a quarter of the time.
    for folder in ("codebook", "cue", "descriptor/local", "filter", "split", "system"):
        for path in (conf / folder).glob("*.yaml"):
            if path.stem != "gist":
                path.unlink()
    (conf / "found.yaml").write_text(found(conf))
    return lambda *overrides: yaml.load(compose(overrides, conf=conf), Loader=Loader)


def test_overrides_reach_their_setting(composed):
    assert composed("cues.gist.classifier.base.nu=0.1")["cues"]["gist"]["classifier"]["base"]["nu"] == 0.1


def test_the_data_set_is_one_override(composed):
    dataset = composed("dataset=my_homes", "dataset.root=somewhere")["dataset"]
    assert (dataset["layout"], dataset["root"]) == ("vpc2009", "somewhere")


@pytest.mark.parametrize(
    ("override", "message"),
    [
        (
            "cues.gist.classifier.base.gama=1",
            r"cues\.gist\.classifier\.base has no setting 'gama'; did you mean",
        ),
        (
            "dataset=home",
            r"dataset has no 'home'; did you mean 'homes'\? \(available: apartments, .*vpc2009\)$",
        ),
        ("classifier@cues.gist.classifier=kn", r"classifier has no 'kn'; did you mean 'knn'\? \(available: "),
        ("dataste=homes", r"conf/ has no setting 'dataste'; did you mean 'dataset'\? \(valid: dataset, "),
        ("attention=1", "attention"),
        ("cues.gist.classifier.base.nu.x=1", r"there is no setting 'cues\.gist\.classifier\.base\.nu\.x'$"),
        ("dataset=my_homes", r"dataset\.root has no value"),
    ],
)
def test_wrong_overrides_are_refused_in_one_line(composed, override, message):
    refused(composed, override, message)


@pytest.mark.parametrize("path", sorted((CONF / "dataset").glob("*.yaml")), ids=lambda path: path.stem)
def test_every_data_set_composes_and_names_a_reader(composed, path):
    from placecat import lookup

    found = composed(f"dataset={path.stem}", "dataset.root=x", "dataset.homes=[a,b,c]")["dataset"]
    assert found["layout"] in lookup.names("placecat.sequences", "read_home")


@pytest.mark.parametrize("path", sorted((CONF / "classifier").glob("*.yaml")), ids=lambda path: path.stem)
def test_every_classifier_builds(composed, path):
    """Every classifier configuration names a model and estimators with valid settings."""
    from placecat.cues import estimators

    found = composed(f"classifier@cues.gist.classifier={path.stem}")["cues"]["gist"]["classifier"]
    assert found["model"] in lookup.names("placecat.cues", "fit")
    if "cue" in found:
        # This model lets another one decide.
        assert found["clusters"] == found["cue"]["clusters"]
        found = found["cue"]
        assert found["model"] in lookup.names("placecat.cues", "fit")
    base = estimators.build(found["base"], "base")
    assert base.get_params().items() >= {k: v for k, v in found["base"].items() if k != "name"}.items()
    if "scheme" in found:
        assert estimators.build(found["scheme"], "scheme", base=base).get_params()["base"] is base


def test_a_failing_composition_keeps_the_old_params(tmp_path):
    target = tmp_path / "params.yaml"
    target.write_text("old: 1\n")
    with pytest.raises(PlacecatError):
        write_params(["dataset=nowhere"], target)
    assert target.read_text() == "old: 1\n"


@pytest.fixture
def own_conf(tmp_path):
    """A copy of the cues and their descriptors, to which tests add others."""
    for folder in ("cue", "codebook", "descriptor"):
        shutil.copytree(CONF / folder, tmp_path / "conf" / folder)
    return tmp_path / "conf"


@pytest.mark.parametrize(
    ("descriptor", "message"),
    [
        (
            "{kind: holistic, name: brightnes}",
            r"cue/new\.yaml: holistic descriptor 'brightnes' does not exist: use",
        ),
        (
            "{kind: holistic, name: ../gist}",
            r"cue/new\.yaml: holistic descriptor '\.\./gist' does not exist; did you mean 'gist'\?: use",
        ),
        ("{kind: holistic", r"cue/new\.yaml is not valid YAML"),
    ],
)
def test_a_cue_with_a_missing_descriptor_is_rejected_with_its_file(own_conf, descriptor, message):
    (own_conf / "cue/new.yaml").write_text(f"codebook: null\ndescriptor: {descriptor}\n")
    refused(found, own_conf, message)


def test_a_file_comes_before_the_defaults_of_the_module(own_conf):
    """Without its file, a descriptor is listed with its defaults if it is used, and not at all otherwise."""
    assert "_self_" not in found(own_conf)
    for name in ("gist", "gist_raw", "centrist", "centrist_full"):
        (own_conf / f"descriptor/holistic/{name}.yaml").unlink()
    for path in own_conf.glob("cue/*pact*.yaml"):
        path.unlink()
    (own_conf / "codebook/centrist_cells.yaml").unlink()
    content = yaml.safe_load(found(own_conf))
    assert content["descriptors"] == {"holistic": {"gist": {"color": True, "center_surround": True}}}


@pytest.mark.parametrize(
    ("setting", "value", "message"),
    [
        (
            "cues.gist.descriptor.name",
            "gits",
            r"cue/gist\.yaml.* no holistic descriptor 'gits'.* mean 'gist'",
        ),
        ("cues.gist.descriptor.kind", "whole", r"cue/gist\.yaml: there is no kind of descriptor 'whole'"),
        ("cues.gist.descriptor.kind", ["local"], r"there is no kind of descriptor \['local'\]"),
        ("cues.gist.descriptor", None, r"cue/gist\.yaml: descriptor needs kind"),
        ("cues.hog_y.codebook", "hog", r"cue/hog_y\.yaml: there is no codebook 'hog'"),
        ("cues.hog_tracked.schemes", ["4-5-1"], r"cue/hog_tracked\.yaml.*for the scheme '4-5-1'.* 5-5-1"),
        ("cues.color_mv_y.extra", True, r"split/apartments.*color_mv_y\.yaml .extra.* no local desc"),
        (
            "codebooks.hog_y.descriptor.color",
            "colour",
            r"codebook/hog_y\.yaml: .* no local descriptor 'colour'",
        ),
        ("systems.das_551_best.cues", ["gits"], r"system/das_551_best\.yaml: there is no cue 'gits'"),
        (
            "systems.das_451_all.cues",
            ["hog_tracked"],
            r"das_451_all\.yaml: .*hog_tracked with the scheme '4-5-1'",
        ),
        ("filters.informative.systems", ["best"], r"filter/informative\.yaml: there is no system 'best'"),
        ("smoothing.cues", ["gits"], r"smoothing\.cues: there is no cue 'gits'"),
        ("smoothing.filtered", ["informative/gits"], r"smoothing\.filtered: .* 'informative/gits'"),
        ("tracking.descriptors", ["surf"], r"tracking\.descriptors: there is no local descriptor 'surf'"),
        ("splits.university.systems.three", ["gits"], r"split/university\.yaml: there is no cue 'gits'"),
        ("splits.university.descriptors.holistic", ["gist"], r"the cue spatial_pact: .* 'centrist'"),
        ("model.system", "best", r"model\.system: there is no system 'best'"),
        ("model.seed", 7, r"model\.seed must be in protocol\.seeds: there is no seed 7 \(available: 0"),
        ("protocol.extra.split", "flats", r"protocol\.extra\.split: there is no split 'flats'"),
    ],
)
def test_missing_references_are_rejected_before_any_stage_runs(setting, value, message):
    refused(references.check, changed(setting, value), message)


def test_an_opinion_pool_needs_cues_that_are_cross_validated():
    pool = {"method": "log_pool", "shrinkage": 0.1}
    params = changed("systems.das_551_best.integrator", pool)
    references.check(params)
    params = changed("cues.sift_y.cross_validate", False, params)
    refused(references.check, params, r"\(method: log_pool\): there is no cross-validated cue 'sift_y'")


@pytest.mark.parametrize("section", ["protocol", "smoothing", "tracking", "descriptors", "dataset"])
def test_a_section_without_settings_has_no_references(section):
    references.check({section: None})


def test_valid_references_pass():
    for params in (PARAMS, {}, {"protocol": {"extra": None}}):
        references.check(params)


def test_params_with_a_missing_reference_are_not_written(tmp_path, monkeypatch):
    light_conf(tmp_path / "conf")
    monkeypatch.chdir(tmp_path)
    with pytest.raises(PlacecatError, match=r"cue/gist\.yaml: there is no holistic descriptor 'gits'"):
        write_params(["cues.gist.descriptor.name=gits"])
    assert {path.name for path in tmp_path.iterdir()} == {"conf"}


def test_the_same_settings_are_composed_once(tmp_path, monkeypatch):
    from placecat.config import compose as module

    (tmp_path / "conf").mkdir()
    monkeypatch.chdir(tmp_path)
    calls = []
    monkeypatch.setattr(module, "compose", lambda overrides: calls.append(overrides) or "figures: {}\n")
    # Each case has a changed file, the overrides, and the number of compositions so far. In the last two
    # cases, settings come from the environment, which may change.
    for file, text, overrides, expected in (
        ("conf/config.yaml", "verdict: {}\n", [], 1),
        (None, None, [], 1),
        (None, None, ["a=1"], 2),
        ("conf/new.yaml", "a: 1\n", ["a=1"], 3),
        ("params.yaml", "edited: 1\n", ["a=1"], 4),
        ("conf/new.yaml", "a: ${oc.env:HOME}\n", ["a=1"], 5),
        (None, None, ["a=1"], 6),
    ):
        if file is not None:
            (tmp_path / file).write_text(text)
        write_params(overrides)
        assert len(calls) == expected, (file, overrides)
        assert (tmp_path / "params.yaml").read_text() == "figures: {}\n"
