"""Pinned seeds of every codebook. Renaming something in conf/ must not change a clustering."""

import pytest

from made_results import PARAMS, STUDIES
from placecat.cues.codebook import seed_of
from placecat.errors import PlacecatError
from placecat.evaluation.trials import expand

CODEBOOKS = {
    "centrist_cells": 2549737421,
    "centrist_tracked": 3799507439,
    "centrist_y": 4074730142,
    "color_mv_y": 1843257155,
    "gist_cells": 128528936,
    "hog_tracked": 1140907970,
    "hog_y": 3474526002,
    "orientation_mv_y": 1453375237,
    "sift_tracked": 965721177,
    "sift_y": 2510385973,
}
# Each key is the first trial that uses the codebook.
TRIALS = {
    "trials/addition_attention/|As used|": 3720955045,
    "trials/addition_attention/|Without spectral residual|": 360805453,
    "trials/addition_attention/|Scales 2 to 4|": 4030123940,
    "trials/addition_attention/|50 regions|": 1775274874,
    "trials/addition_discriminative_regions/Naive Bayes|All regions|": 3474526002,
    "trials/table_01/||46": 3210188019,
    "trials/table_04/First-Order Dependency Tree||31": 128528936,
    "trials/table_16/Ori M/V||46": 1889598645,
    "trials/table_16/HOG||46": 1860920748,
    "trials/table_16/SIFT||46": 1098084241,
    "trials/table_16/Centrist||46": 2244670792,
    "trials/table_16/Color M/V||46": 917401692,
    "trials/table_17/Ori M/V + y-Pos||46": 1453375237,
    "trials/table_17/SIFT + y-Pos||46": 2510385973,
    "trials/table_17/Centrist + y-Pos||46": 4074730142,
    "trials/table_17/Color M/V + y-Pos||46": 1843257155,
    "trials/table_18/Ori M/V + y-Pos + Color M/V||46": 3466859288,
    "trials/table_18/HOG + y-Pos + Color M/V||46": 1969787815,
    "trials/table_18/SIFT + y-Pos + Color M/V||46": 2560764093,
    "trials/table_18/Centrist + y-Pos + Color M/V||46": 3334973559,
    "trials/table_22/|Ori M/V + y-Pos|12": 2811948124,
    "trials/table_22/|Ori M/V + y-Pos|38": 1648847086,
    "trials/table_22/|HOG + y-Pos|12": 1765755066,
    "trials/table_22/|HOG + y-Pos|38": 3297024332,
    "trials/table_22/|SIFT + y-Pos|12": 3082983003,
    "trials/table_22/|SIFT + y-Pos|38": 1850012036,
    "trials/table_22/|Centrist + y-Pos|12": 1676724663,
    "trials/table_22/|Centrist + y-Pos|38": 2672729966,
    "trials/table_22/|Color M/V + y-Pos|12": 203082463,
    "trials/table_22/|Color M/V + y-Pos|38": 3722284734,
    "trials/reading_sift/||": 1899530739,
    "trials/centrist_full_size/||": 3772834857,
    "trials/centrist_on_intensity/||": 3513956324,
    "trials/color_mv_short/Ori M/V + y-Pos + Color M/V||46": 3291867160,
    "trials/color_mv_short/HOG + y-Pos + Color M/V||46": 3172863562,
    "trials/color_mv_short/SIFT + y-Pos + Color M/V||46": 3199559879,
    "trials/color_mv_short/Centrist + y-Pos + Color M/V||46": 1203283200,
    "trials/gist_without_center_surround/||": 678789689,
    "trials/gist_without_color/||": 3792614820,
    "trials/region_centrist_on_laplacian/||": 3730867142,
}


def seed(descriptor, cells):
    return seed_of("homes", descriptor, cells, "without-home_1", 0)


def test_seeds_of_the_codebooks_are_unchanged():
    assert {
        name: seed(own["descriptor"], own["cells"]) for name, own in PARAMS["codebooks"].items()
    } == CODEBOOKS
    hog = PARAMS["codebooks"]["hog_y"]["descriptor"]
    sites = {site: seed_of(site, hog, 1, site, 0) for site in PARAMS["splits"]}
    assert sites == {"apartments": 2233546322, "university": 140981420}
    assert seed_of("homes", hog, 1, "without-home_1", 1) != CODEBOOKS["hog_y"]


def test_seeds_of_the_trials_are_unchanged():
    first = {}
    for study in STUDIES.values():
        for name, table in study.items():
            for trial in expand(name, table, PARAMS["dataset"]["homes"]):
                shared = trial.settings.get("codebook")
                if shared is not None:
                    first.setdefault(seed(trial.settings["descriptor"], shared["cells"]), trial.name)
    assert {name: number for number, name in first.items()} == TRIALS


def test_a_setting_without_a_pinned_seed_is_rejected():
    with pytest.raises(PlacecatError, match="no setting 'sharpness'"):
        seed({"kind": "holistic", "name": "gist", "sharpness": 1}, 1)
