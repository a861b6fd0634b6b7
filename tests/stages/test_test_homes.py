"""With `protocol.test_homes`, tested homes have the same numbers as without it, and others have a reason."""

import numpy as np
import pandas as pd
import pytest
from made_features import CLASSES, HOMES, PARAMS, make, run_stages

from placecat import files
from placecat.results.measured import from_scores
from placecat.thesis.number import in_home, over_homes
from placecat.training.protocol import NOT_TESTED

TESTED = ["H4", "H2"]
FOLDERS = ("cues", "integration", "filtered", "smoothing")
# A cue with clusters and a cue without, and the results based on them.
SMALL = PARAMS | {
    section: {name: PARAMS[section][name] for name in names}
    for section, names in {
        "codebooks": ["hog_y"],
        "cues": ["hog_y", "gist"],
        "systems": ["das"],
    }.items()
}

pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def folders(tmp_path_factory):
    made = {}
    for name, tested in (("all", "all"), ("some", TESTED)):
        params = SMALL | {"protocol": PARAMS["protocol"] | {"test_homes": tested}}
        made[name] = tmp_path_factory.mktemp(name)
        with pytest.MonkeyPatch.context() as patch:
            make(made[name], params=params)
            run_stages(made[name], patch)
            (made[name] / "data/toy.csv").write_text("result,home,seed,truth,decision,frames\n")
            from placecat.stages import scores

            scores.main()
    return made


def arrays(folder):
    return {
        f"{path.relative_to(folder / 'data').as_posix()}/{name}": array
        for kind in FOLDERS
        for path in sorted((folder / "data" / kind).rglob("*.npz"))
        for name, array in files.read_arrays(path).items()
    }


def results(folder):
    tables = [pd.read_csv(folder / f"data/scores/{name}.csv") for name in ("scores", "missing")]
    return from_scores(*tables, HOMES, CLASSES, [PARAMS["splits"]["site"]["dataset"]["classes"]])


def test_tested_homes_have_the_same_bytes_and_others_no_files(folders):
    everything, some = arrays(folders["all"]), arrays(folders["some"])
    expected = {name: one for name, one in everything.items() if name.split("/")[-2].split(".")[0] in TESTED}
    assert 0 < len(expected) < len(everything)
    assert some.keys() == expected.keys()
    for name, one in some.items():
        assert one.tobytes() == expected[name].tobytes(), name


def test_scores_of_tested_homes_are_the_same_and_others_have_a_reason(folders):
    everything, some = results(folders["all"]), results(folders["some"])
    for name, one in some.measured.items():
        if name.startswith("splits/"):
            continue
        assert set(one.homes) <= set(TESTED)
        for number, home in enumerate(HOMES, start=1):
            if home in one.homes:
                expected = in_home(everything, name, number)
                np.testing.assert_array_equal(in_home(some, name, number).values, expected.values)
            elif (name, home) in some.missing:
                assert in_home(some, name, number).notes == (NOT_TESTED,)
    average = over_homes(some, "smoothing/das", range(1, 5))
    assert average.notes == ("mean over only Home 2, Home 4",)


def test_a_trial_without_tested_homes_has_only_reasons(folders):
    """Table 1 needs homes 1 and 3."""
    some = results(folders["some"])
    name = "trials/table_01/||13"
    assert name in results(folders["all"]).measured and name not in some.measured
    assert [in_home(some, name, number).notes for number in (1, 3)] == [(NOT_TESTED,)] * 2
