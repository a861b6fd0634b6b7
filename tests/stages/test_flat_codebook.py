"""The stages can use flat k-means for a codebook, with the cluster numbers that its cues need."""

import numpy as np
from made_features import PARAMS, make

from placecat.cues.codebook import Codebook
from placecat.stages import codebooks, cues
from placecat.training import fold_file

CLUSTERS = {"hog_y": 5, "hog_y_knn": 8}
FLAT = PARAMS | {
    "protocol": PARAMS["protocol"] | {"test_homes": ["H1"], "seeds": [0]},
    "codebooks": {
        "hog_y": PARAMS["codebooks"]["hog_y"]
        | {"schemes": ["5-5-1"], "tree": {"name": "flat_kmeans", "max_iter": 5}},
    },
    "cues": {
        name: PARAMS["cues"][name]
        | {"schemes": ["5-5-1"], "classifier": PARAMS["cues"][name]["classifier"] | {"clusters": clusters}}
        for name, clusters in CLUSTERS.items()
    },
}


def test_cues_use_the_codebook(tmp_path, monkeypatch):
    make(tmp_path, params=FLAT)
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("PLACECAT_WORKERS", "1")
    codebooks.main()
    cues.main()
    for name in CLUSTERS:
        proba = fold_file.read(next((tmp_path / f"data/cues/{name}").rglob("*.npz")), "test")
        np.testing.assert_allclose(proba.sum(axis=1), 1)
        assert len(np.unique(proba.round(6), axis=0)) > 1
    (file,) = tmp_path.glob("data/codebooks/hog_y/*H1*.npz")
    with np.load(file) as arrays:
        (flat,) = Codebook.from_arrays(dict(arrays)).trees
    assert [flat.centers(number).shape for number in CLUSTERS.values()] == [(5, 9), (8, 9)]
