"""A tiny project after the stage `features`, with random descriptors that depend on the place."""

import json
import os

import numpy as np
import pandas as pd
import pytest
import yaml
from filelock import FileLock

HOMES = ["H1", "H2", "H3", "H4"]
CLASSES = ["bedroom", "kitchen", "bathroom"]
FRAMES = 90
REGIONS = 4

PARAMS = {
    "dataset": {"name": "made", "homes": HOMES, "classes": CLASSES},
    "protocol": {
        "schemes": ["5-5-1", "4-5-1"],
        "test_homes": "all",
        "seeds": [0, 1],
        "extra": {"split": "site", "sequences": ["flip"]},
        "cue_frames": {"offset": 0, "step": 3},
        "integration_frames": {"offset": 1, "step": 3},
    },
    "region_variants": {"frames": {"offset": 0, "step": 3}, "descriptors": ["hog"], "variants": {}},
    "codebooks": {
        "hog_y": {
            "descriptor": {
                "kind": "local",
                "name": "hog",
                "y_pos": True,
                "y_weight": 1.0,
                "color": "color_mv",
                "max_regions": REGIONS,
            },
            "cells": 1,
            "schemes": ["5-5-1", "4-5-1"],
            "tree": {"name": "hierarchical_kmeans", "max_clusters": 16, "branching": 4, "max_iter": 5},
        },
        "gist_cells": {
            "descriptor": {"kind": "holistic", "name": "gist"},
            "cells": 4,
            "schemes": ["5-5-1", "4-5-1"],
            "tree": {"name": "hierarchical_kmeans", "max_clusters": 7, "branching": 4, "max_iter": 5},
        },
    },
    "cues": {
        "hog_y": {
            "codebook": "hog_y",
            "schemes": ["5-5-1", "4-5-1"],
            "cross_validate": True,
            "extra": True,
            "classifier": {
                "model": "joint_probability",
                "base": {"name": "naive_bayes", "alpha": 1.0},
                "clusters": 13,
            },
        },
        "hog_y_knn": {
            "codebook": "hog_y",
            "schemes": ["5-5-1"],
            "cross_validate": False,
            "extra": False,
            "classifier": {"model": "knn", "base": {"name": "knn"}, "clusters": 13},
        },
        "gist_tree": {
            "codebook": "gist_cells",
            "schemes": ["5-5-1"],
            "cross_validate": False,
            "extra": False,
            "classifier": {
                "model": "joint_probability",
                "base": {"name": "dependency_tree", "alpha": 1.0},
                "clusters": 7,
            },
        },
        "gist": {
            "codebook": None,
            "descriptor": {"kind": "holistic", "name": "gist"},
            "schemes": ["5-5-1", "4-5-1"],
            "cross_validate": True,
            "extra": True,
            "classifier": {
                "model": "one_against_all",
                "base": {"name": "nu_svm", "gamma": 2.0, "nu": 0.2},
                "scheme": {"name": "one_against_all"},
                "scaling": "standard",
                "reduction": {"cells": 4, "components": 3},
            },
        },
    },
    "systems": {
        "das": {
            "scheme": "5-5-1",
            "temperature": False,
            "extra": False,
            "cues": ["hog_y", "gist"],
            "integrator": {
                "method": "das",
                "classifier": {
                    "model": "one_against_all",
                    "base": {"name": "nu_svm", "gamma": 2.0, "nu": 0.2},
                    "scheme": {"name": "one_against_all"},
                    "scaling": "none",
                },
            },
        },
        "das_451": {
            "scheme": "4-5-1",
            "temperature": True,
            "extra": False,
            "cues": ["hog_y", "gist"],
            "integrator": {
                "method": "das",
                "classifier": {
                    "model": "one_against_all",
                    "base": {"name": "nu_svm", "gamma": 2.0, "nu": 0.2},
                    "scheme": {"name": "one_against_all"},
                    "scaling": "none",
                },
            },
        },
        "vote": {
            "scheme": "5-5-1",
            "temperature": False,
            "extra": True,
            "cues": ["hog_y", "gist"],
            "integrator": {"method": "vote_distribution"},
        },
        "pool": {
            "scheme": "5-5-1",
            "temperature": False,
            "extra": False,
            "cues": ["hog_y", "gist"],
            "integrator": {"method": "log_pool", "shrinkage": 0.01},
        },
    },
    "filters": {"informative": {"threshold": 0.3, "cues": ["gist"], "systems": ["das"]}},
    "splits": {
        "site": {
            "dataset": {"classes": ["kitchen", "office", "bedroom", "bathroom"], "homes": ["flip", "robot"]},
            "cue_parts": [{"sequence": "flip", "places": None}],
            "integration_parts": [{"sequence": "flip", "places": None}],
            "test": ["robot"],
            "systems": {"two": ["hog_y", "gist"]},
            "integrator": {"method": "vote_distribution"},
        }
    },
    "probabilities": {"bins": 10, "smallest": 1e-9},
    "smoothing": {
        "delay_seconds": 1.0,
        "evidence": "soft",
        "evidence_seconds": 1.0,
        "reliability": "hard",
        "transition_counts": 1.0,
        "emission_counts": 1.0,
        "cues": ["gist"],
        "filtered": ["informative/gist", "informative/das"],
    },
}

STUDIES = {
    "some": {
        "table_01": {
            "homes": [1, 3, 9],
            "trial": {
                "descriptor": {"kind": "holistic", "name": "gist"},
                "codebook": {
                    "cells": 1,
                    "tree": {
                        "name": "hierarchical_kmeans",
                        "max_clusters": 7,
                        "branching": 4,
                        "max_iter": 5,
                    },
                },
                "classifier": {"model": "knn", "base": {"name": "knn", "smoothing": 1.0}, "clusters": 7},
            },
            "axes": {
                "row": "homes",
                "column": {
                    "4": {"classifier.clusters": 4},
                    "13": {"classifier.clusters": 13},
                    "400": {"classifier.clusters": 400},
                },
            },
        },
        "table_02": {
            "homes": "all",
            "trial": {
                "descriptor": {"kind": "holistic", "name": "gist"},
                "classifier": {
                    "model": "one_against_all",
                    "base": {"name": "nu_svm", "gamma": 2.0, "nu": 0.2},
                    "scheme": {"name": "one_against_all"},
                    "scaling": "standard",
                    "reduction": None,
                },
            },
            "axes": {"row": {"PCA": {"classifier.reduction": {"cells": 4, "components": 3}}}},
        },
    }
}


def make(folder, *, marked=None, params=PARAMS):
    """Write the project; the home `marked` gets different descriptors, labels and regions."""
    (folder / "params.yaml").write_text(yaml.safe_dump(params))
    for study, tables in STUDIES.items():
        for name, table in tables.items():
            path = folder / f"data/thesis/tables/{study}/{name}.yaml"
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(yaml.safe_dump(table, sort_keys=False))
    places = {home: (f"data/sequences/{home}", f"data/features/{home}", 3) for home in HOMES}
    for sequence in params["splits"]["site"]["dataset"]["homes"]:
        places[sequence] = (
            f"data/site_sequences/site/{sequence}",
            f"data/site_features/site/{sequence}",
            4,
        )
    for number, (home, (sequences, features, classes)) in enumerate(places.items()):
        rng = np.random.default_rng([number, home == marked])
        seen = [*range(classes), -1]
        labels = np.repeat(rng.permutation([*seen, *seen, 1][:9]), FRAMES // 9)
        shift = 0.5 * labels[:, None]
        arrays = {
            "count": rng.integers(0, REGIONS + 1, FRAMES).astype(np.int16),
            "information": rng.random(FRAMES, np.float32),
            "regions": rng.random((FRAMES, REGIONS, 4), np.float32),
            "local_hog": (rng.normal(size=(FRAMES, REGIONS, 6)) + shift[:, None]).astype(np.float32),
            "local_color_mv": rng.normal(size=(FRAMES, REGIONS, 2)).astype(np.float32),
            "holistic_gist": (rng.normal(size=(FRAMES, 16)) + shift).astype(np.float32),
        }
        if home == marked:
            arrays = {name: array if name == "count" else array + 3 for name, array in arrays.items()}
        (folder / features).mkdir(parents=True)
        for name, array in arrays.items():
            np.save(folder / features / f"{name}.npy", array)
        (folder / features / "descriptors.json").write_text('{"hog": "hog", "color_mv": "color_mv"}')
        (folder / sequences).mkdir(parents=True)
        frames = pd.DataFrame({"sequence": ["1"] * 50 + ["2"] * 40, "source": "x"})
        frames.to_csv(folder / sequences / "frames.csv", index=False)
        pd.DataFrame({"label": "x", "class": labels}).to_csv(folder / sequences / "labels.csv", index=False)
        (folder / sequences / "home.json").write_text(json.dumps({"height": 360, "width": 640, "fps": 5}))


def run_stages(folder, monkeypatch):
    """Run the stages from `codebooks` to `trials` in this process."""
    from placecat.stages import codebooks, cues, filtering, integration, smoothing, splits, trials

    monkeypatch.chdir(folder)
    monkeypatch.setenv("PLACECAT_WORKERS", "1")
    codebooks.main()
    cues.main()
    integration.main()
    filtering.main()
    smoothing.main()
    splits.main()
    trials.main()


def ran_once(tmp_path_factory):
    """Run the stages once for all workers; return the folder, which tests do not change."""
    shared = tmp_path_factory.getbasetemp()
    if "PYTEST_XDIST_WORKER" in os.environ:
        shared = shared.parent
    folder, done = shared / "made_features", shared / "made_features.done"
    with FileLock(shared / "made_features.lock"):
        if not done.exists():
            folder.mkdir()
            with pytest.MonkeyPatch.context() as patch:
                make(folder)
                run_stages(folder, patch)
            done.touch()
    return folder
