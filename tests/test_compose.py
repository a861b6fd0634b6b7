from pathlib import Path

import pytest
import yaml

from placecat.compose import compose, write_params
from placecat.errors import PlacecatError
from project import light_conf

CONF = Path(__file__).resolve().parents[1] / "conf"


@pytest.fixture(scope="module")
def composed(tmp_path_factory):
    conf = light_conf(tmp_path_factory.mktemp("light") / "conf")
    return lambda *overrides: yaml.safe_load(compose(overrides, conf=conf))


def test_overrides_reach_their_setting(composed):
    assert composed("cues.gist.classifier.base.nu=0.1")["cues"]["gist"]["classifier"]["base"]["nu"] == 0.1


def test_the_data_set_is_one_override(composed):
    dataset = composed("dataset=my_homes", "dataset.root=somewhere")["dataset"]
    assert (dataset["layout"], dataset["root"]) == ("vpc2009", "somewhere")


@pytest.mark.parametrize(
    ("override", "message"),
    [
        ("cues.gist.classifier.base.gama=1", "gama"),
        ("dataset=nowhere", "nowhere"),
        ("dataset=my_homes", r"dataset\.root has no value"),
    ],
)
def test_wrong_overrides_are_refused_in_one_line(composed, override, message):
    with pytest.raises(PlacecatError, match=message) as caught:
        composed(override)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("path", sorted((CONF / "dataset").glob("*.yaml")), ids=lambda path: path.stem)
def test_every_data_set_composes_and_names_a_reader(composed, path):
    from placecat.sequences import layouts

    found = composed(f"dataset={path.stem}", "dataset.root=x", "dataset.homes=[a,b,c]")["dataset"]
    assert found["layout"] in layouts()


@pytest.mark.parametrize("path", sorted((CONF / "classifier").glob("*.yaml")), ids=lambda path: path.stem)
def test_every_classifier_builds(composed, path):
    """Every classifier's configuration names a way of deciding and estimators with valid settings."""
    from placecat import cues
    from placecat.cues import estimators

    found = composed(f"classifier@cues.gist.classifier={path.stem}")["cues"]["gist"]["classifier"]
    assert found["model"] in cues.model_names()
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
