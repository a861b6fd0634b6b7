"""A small system that is trained on random descriptors, without a pipeline."""

import numpy as np

from placecat import cues
from placecat.categorizer.card import make_card
from placecat.categorizer.system import TrainedCue, TrainedSystem
from placecat.cues import Codebook, Descriptors
from placecat.fusion import integrate, smoothing
from placecat.vision.frame import describe_frame

CLASSES = ["bedroom", "kitchen", "bathroom"]
SIZE = (320, 180)
GIST = {"kind": "holistic", "name": "gist"}
HOG = {"kind": "local", "name": "hog", "y_pos": True, "y_weight": 1.0, "color": None, "max_regions": 10}
VISION = {
    "attention": {},
    "regions": {"max_regions": 10},
    "information": {},
    "local": {"hog": {}},
    "holistic": {"gist": {}},
}
SVM = {
    "model": "one_against_all",
    "base": {"name": "nu_svm", "gamma": 0.001, "nu": 0.3},
    "scheme": {"name": "one_against_all"},
    "scaling": "none",
}
BAYES = {"model": "joint_probability", "base": {"name": "naive_bayes"}, "clusters": 16}
SMOOTHING = {
    "delay_seconds": 2.0,
    "evidence": "soft",
    "evidence_seconds": 1.0,
    "reliability": "soft",
    "transition_counts": 1.0,
    "emission_counts": 1.0,
}
UNKNOWN = {
    "risk": 0.1,
    "threshold": 0.4,
    "measured": [
        {"risk": 0.1, "threshold": 0.4, "coverage": 0.625, "wrong": 0.125, "worst": 0.25},
        {"risk": 0.01, "threshold": None, "coverage": 0, "wrong": None, "worst": None},
    ],
}


def make_system(tracked=False):
    rng = np.random.default_rng(0)
    n = 90
    labels = np.tile(np.arange(3), n // 3).astype(np.int16)
    homes = np.repeat(["a", "b", "c"], n // 3)
    blank = np.zeros((256, 256, 3), np.uint8)
    shapes = {name: array.shape for name, array in describe_frame(blank, VISION).items()}
    whole = Descriptors(rng.random((n, *shapes["holistic_gist"]), dtype=np.float32) + labels[:, None] / 9)
    _, size = shapes["local_hog"]
    sets = Descriptors(rng.random((n, 10, size + 1), dtype=np.float32), rng.integers(0, 11, n))
    tree = {"name": "hierarchical_kmeans", "max_clusters": 16, "branching": 16, "max_iter": 11}
    codebook = Codebook.fit(sets, cells=1, seed=1, tree=tree)
    trained = (
        TrainedCue("gist", GIST, cues.fit(whole, labels, homes, classifier=SVM, classes=CLASSES)),
        TrainedCue(
            "hog_y",
            HOG | ({"tracked": True} if tracked else {}),
            cues.fit(sets, labels, homes, classifier=BAYES, classes=CLASSES, codebook=codebook),
        ),
    )
    proba = np.stack([trained[0].model.predict_proba(whole), trained[1].model.predict_proba(sets)], axis=1)
    by_home = {home: proba[homes == home] for home in np.unique(homes)}
    truth = {home: labels[homes == home] for home in by_home}
    fused = integrate.fit(by_home, truth, CLASSES, method="das", classifier=SVM)
    smooth = smoothing.fit(
        list(truth.values()),
        fused.cross_validated,
        fused.truth,
        3,
        training_frame_rates=[5.0] * len(truth),
        **SMOOTHING,
    )
    card = make_card(
        title="small system",
        data={
            "title": "noise",
            "note": "It hums.",
            "version": "v",
            "homes": ["a"],
            "left_out": ["c", "d"],
            "frames": {"cues": 1, "integration": 1},
        },
        classes=CLASSES,
        frame_sizes=[SIZE],
        fps=[5.0],
        accuracy={"a": 50.0, "b": 25.0},
        unknown=UNKNOWN,
        settings={},
    )
    tracking = {"max_regions": 10} if tracked else None
    return TrainedSystem(card, VISION, tracking, trained, fused.integrator, smooth)


def frames(number, seed=0):
    """Return frames that are each shifted slightly from the previous one."""
    rng = np.random.default_rng(seed)
    width, height = SIZE
    wide = rng.integers(0, 256, (height // 12, width // 8, 3), dtype=np.uint8)
    wide = np.kron(wide, np.ones((12, 12, 1), np.uint8))
    return [np.ascontiguousarray(wide[:height, 3 * i : 3 * i + width]) for i in range(number)]
