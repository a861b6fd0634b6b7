"""Paths relative to the project folder, in which every stage runs."""

from pathlib import Path

CONF = Path("conf")
PARAMS = Path("params.yaml")
DATA = Path("data")
CONTACT_SHEET = Path("data/contact_sheet.jpg")
PUBLISHED = Path("data/thesis/published_tables.csv")
PUBLISHED_TEXT = Path("data/thesis/published_text.csv")
TABLE_DEFINITIONS = Path("data/thesis/tables")
FINDING_DEFINITIONS = Path("data/thesis/findings")
IN_TEXT_DEFINITIONS = Path("data/thesis/in_text.yaml")
METRIC_DEFINITIONS = Path("data/thesis/metrics.yaml")
PLOT_DEFINITIONS = Path("data/thesis/plots.yaml")
CONTRADICTIONS = Path("data/thesis/contradictions.csv")
SEQUENCES = Path("data/sequences")
FEATURES = Path("data/features")
CODEBOOKS = Path("data/codebooks")
CUES = Path("data/cues")
INTEGRATION = Path("data/integration")
SMOOTHING = Path("data/smoothing")
TRACKS = Path("data/tracks")
FILTERED = Path("data/filtered")
SITE_SEQUENCES = Path("data/site_sequences")
SITE_FEATURES = Path("data/site_features")
SPLITS = Path("data/splits")
TRIALS = Path("data/trials")
TOY = Path("data/toy.csv")
SCORES = Path("data/scores")
NOTES = Path("data/notes.csv")
ORIGINS = Path("data/origins.json")
MODEL = Path("data/model.placecat")
MODELS = Path("data/models")
TRACKING = Path("data/tracking.json")
TIMES = Path("data/times")
LAST_TIMES = Path("data/times.csv")
COMPLETE_TIMES = Path("data/times.json")
SCALE = Path("data/scale")
REPLICATION_DATA = Path("data/replication")
COMPUTE = Path("data/compute")
REPORTS = Path("reports")
TABLES = Path("reports/tables")
OPTIONAL_TABLES = Path("reports/optional_tables")
ACCURACIES = Path("reports/accuracies.csv")
CROSS_VALIDATION = Path("reports/cross_validation.csv")
PROBABILITIES = Path("reports/probabilities.csv")
IN_TEXT = Path("reports/in_text.csv")
FINDINGS = Path("reports/findings.csv")
COMPARISONS = Path("reports/findings_comparisons.csv")
METRICS = Path("reports/metrics.json")
SUMMARY = Path("reports/summary.json")
PLOTS = Path("reports/plots")
FIGURES = Path("reports/figures")
KEPT_TIMES = Path("reports/times.csv")
KEPT_TIMES_FACTS = Path("reports/times.json")
BENCHMARKS = Path("reports/benchmarks.csv")
SCALE_STAGES = Path("reports/scale.csv")
SCALE_GROWTH = Path("reports/scale_growth.csv")
SCALE_FACTS = Path("reports/scale.json")
PAGE = Path("reports/index.html")
RESULTS = Path("reports/results.parquet")
EXPLANATIONS = Path("reports/explanations.json")
REPLICATION = Path("reports/replication")
REPLICATION_FACTS = Path("reports/replication/facts.json")
REPLICATED_FINDINGS = Path("reports/replication/findings.csv")

# Seed name for results that are not random.
NO_SEED = "no-seed"
# Within the features folder of a home: the folder of a region variant, and its list of frames.
VARIANT = "variant_{}"
VARIANT_FRAMES = "frames.npy"


def sequences(home: str) -> Path:
    """Return the folder for frames and labels of a home (``home_1``) or sequence (``university/north_2``)."""
    return (SITE_SEQUENCES if "/" in home else SEQUENCES) / home


def features(home: str) -> Path:
    """Return the folder with the descriptors of a home (`home` as in :func:`sequences`)."""
    return (SITE_FEATURES if "/" in home else FEATURES) / home


def seed_name(seed: int | None) -> str:
    """Return the seed part of a file name: `seed-0`, or `no-seed` if nothing is random."""
    return NO_SEED if seed is None else f"seed-{seed}"


def codebook(name: str, training_set: str, seed: int) -> Path:
    """Return the codebook file for a training set (see :class:`placecat.training.plan.Plan`) and a seed."""
    return CODEBOOKS / name / f"{training_set}.{seed_name(seed)}.npz"
