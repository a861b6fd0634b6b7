"""A tiny project after the stage `features`: random descriptors that tell the place a little."""

import json

import numpy as np
import pandas as pd
import yaml

HOMES = ["H1", "H2", "H3", "H4"]
CLASSES = ["bedroom", "kitchen", "bathroom"]
FRAMES = 90
REGIONS = 4

PARAMS = {
    "dataset": {"name": "made", "homes": HOMES, "classes": CLASSES},
    "protocol": {
        "schemes": ["5-5-1", "4-5-1"],
        "cue_frames": {"offset": 0, "step": 3},
        "integration_frames": {"offset": 1, "step": 3},
    },
    "codebooks": {
        "hog_y": {
            "descriptor": {
                "kind": "local",
                "name": "hog",
                "y_pos": True,
                "y_weight": 1.0,
                "color": True,
                "max_regions": REGIONS,
            },
            "cells": 1,
            "seed": 0,
            "tree": {"max_clusters": 16, "branching": 4, "max_iter": 5},
        },
        "gist_cells": {
            "descriptor": {"kind": "holistic", "name": "gist"},
            "cells": 4,
            "seed": 0,
            "tree": {"max_clusters": 7, "branching": 4, "max_iter": 5},
        },
    },
    "cues": {
        "hog_y": {
            "codebook": "hog_y",
            "schemes": ["5-5-1", "4-5-1"],
            "classifier": {
                "model": "joint_probability",
                "base": {"name": "naive_bayes", "alpha": 1.0},
                "clusters": 13,
            },
        },
        "hog_y_knn": {
            "codebook": "hog_y",
            "schemes": ["5-5-1"],
            "classifier": {"model": "knn", "base": {"name": "knn"}, "clusters": 13},
        },
        "gist_tree": {
            "codebook": "gist_cells",
            "schemes": ["5-5-1"],
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
        "vote": {"scheme": "5-5-1", "cues": ["hog_y", "gist"], "integrator": {"method": "vote_distribution"}},
    },
    "smoothing": {
        "delay_step": 0.2,
        "evidence": "soft",
        "reliability": "hard",
        "transition_counts": 1.0,
        "emission_counts": 1.0,
        "cues": ["gist"],
    },
}


def make(folder, *, marked=None, params=PARAMS):
    """Write the project; with `marked`, that home gets other descriptors, labels and regions."""
    (folder / "params.yaml").write_text(yaml.safe_dump(params))
    for number, home in enumerate(HOMES):
        rng = np.random.default_rng([number, home == marked])
        labels = np.repeat(rng.permutation([0, 1, 2, -1, 0, 1, 2, -1, 1]), FRAMES // 9)
        shift = 0.5 * labels[:, None]
        arrays = {
            "count": rng.integers(0, REGIONS + 1, FRAMES).astype(np.int16),
            "regions": rng.random((FRAMES, REGIONS, 4), np.float32),
            "local_hog": (rng.normal(size=(FRAMES, REGIONS, 6)) + shift[:, None]).astype(np.float32),
            "local_color_mv": rng.normal(size=(FRAMES, REGIONS, 2)).astype(np.float32),
            "holistic_gist": (rng.normal(size=(FRAMES, 16)) + shift).astype(np.float32),
        }
        if home == marked:
            arrays = {name: array if name == "count" else array + 3 for name, array in arrays.items()}
        (folder / "data/features" / home).mkdir(parents=True)
        for name, array in arrays.items():
            np.save(folder / "data/features" / home / f"{name}.npy", array)
        sequences = folder / "data/sequences" / home
        sequences.mkdir(parents=True)
        frames = pd.DataFrame({"sequence": ["1"] * 50 + ["2"] * 40, "source": "x"})
        frames.to_csv(sequences / "frames.csv", index=False)
        pd.DataFrame({"label": "x", "class": labels}).to_csv(sequences / "labels.csv", index=False)
        (sequences / "home.json").write_text(json.dumps({"height": 360, "width": 640, "fps": 5}))


def run_stages(folder, monkeypatch, params=PARAMS):
    """Run the stages from the codebooks to the smoothing in this process."""
    from placecat.stages import codebooks, cues, integration, smoothing

    monkeypatch.chdir(folder)
    monkeypatch.setenv("PLACECAT_WORKERS", "1")
    for name in params["codebooks"]:
        codebooks.main(name)
    for name in params["cues"]:
        cues.main(name)
    for name in params["systems"]:
        integration.main(name)
    smoothing.main()
