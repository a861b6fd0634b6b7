"""Test plans on synthetic data: training homes and frames, tested homes, and names that seeds depend on."""

import numpy as np
import pytest
from made_features import HOMES, PARAMS, make

from placecat.sequences import listing
from placecat.training import plan as plans
from placecat.training.protocol import training_homes


def names(parts):
    return [part.home for part in parts]


@pytest.mark.parametrize("scheme", ["5-5-1", "4-5-1"])
def test_of_homes_plans_one_fold_per_home(scheme):
    found = plans.of_homes(PARAMS, scheme)
    for number, (plan, home) in enumerate(zip(found, HOMES, strict=True)):
        cues, integration = training_homes(HOMES, scheme, [home])
        kept = f"-{HOMES[(number + 1) % len(HOMES)]}" if scheme == "4-5-1" else ""
        assert (plan.test, plan.training_set, plan.dataset) == (home, f"without-{home}{kept}", "made")
        assert names(plan.cues) == list(cues)
        assert names(plan.integration) == list(integration)
        assert {(part.offset, part.step) for part in plan.cues} == {(0, 3)}
        assert {(part.offset, part.step) for part in plan.integration} == {(1, 3)}
        assert plan.extra == ()


def test_extra_sequences_match_places_by_name():
    (plan,) = plans.of_homes(PARAMS, "5-5-1", "H2", extra=True)
    (part,) = plan.extra
    # The places are kitchen, office, bedroom and bathroom. The homes have no office.
    assert (part.home, part.sequence, part.numbers) == ("site/flip", "flip", (1, -1, 0, 2))


def test_a_release_trains_on_all_homes_and_folds_can_be_selected():
    everything = plans.of_release(PARAMS, "5-5-1")
    assert (names(everything.cues), everything.tested, everything.training_set) == (HOMES, (), "all")
    assert plans.of_homes(PARAMS, "4-5-1", ["H4", "H3"]) == plans.of_homes(PARAMS, "4-5-1")[2:]


def test_training_homes_are_tested_without_the_test_home():
    (plan,) = plans.of_homes(PARAMS, "5-5-1", "H3")
    judged = plans.on_training_homes(plan)
    assert [one.test for one in judged] == ["H1", "H2", "H4"]
    assert names(judged[1].cues) == names(judged[1].integration) == ["H1", "H4"]
    assert judged[1].training_set == "without-H2-H3"
    assert (judged[1].tested[0].offset, judged[1].tested[0].step) == (0, 1)
    assert judged[1].with_cue_frames({"offset": 2, "step": 5}).cues[0].offset == 2


def test_left_out_homes_are_only_tested():
    plan = plans.without_homes(PARAMS, ("H4", "H1"))
    assert names(plan.cues) == names(plan.integration) == ["H2", "H3"]
    assert (names(plan.tested), plan.training_set) == (["H4", "H1"], "without-H4-H1")


def split_params(places):
    own = PARAMS["splits"]["site"] | {"cue_parts": [{"sequence": "flip", "places": places}]}
    return PARAMS | {"splits": {"site": own}}


def test_a_split_is_fixed_and_names_its_training_set():
    plan = plans.of_split(split_params(None), "site")
    assert (names(plan.cues), plan.test) == (["site/flip"], "site/robot")
    assert (plan.dataset, plan.training_set) == ("site", "site")
    assert plan.classes == ("kitchen", "office", "bedroom", "bathroom")


def test_places_that_are_not_listed_in_a_part_do_not_count(tmp_path, monkeypatch):
    make(tmp_path)
    monkeypatch.chdir(tmp_path)
    part = plans.of_split(split_params(["bathroom", "office"]), "site").cues[0]
    labels = listing.read_labels("site/flip")
    np.testing.assert_array_equal(part.labels(), np.where(np.isin(labels, [1, 3]), labels, -1))
    rows, truth = part.chosen()
    expected = [row for row in range(0, 90, 3) if labels[row] in (1, 3)]
    assert rows.tolist() == expected and len(expected) > 2
    assert truth.tolist() == labels[expected].tolist()
    assert part.labels().dtype == truth.dtype == np.int16
