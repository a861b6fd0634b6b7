"""Where things are, relative to the folder that holds dvc.yaml; every stage runs there."""

from pathlib import Path

CONF = Path("conf")
PARAMS = Path("params.yaml")
DATA = Path("data")
CONTACT_SHEET = Path("data/contact_sheet.jpg")
PUBLISHED = Path("data/thesis/published_tables.csv")
SEQUENCES = Path("data/sequences")
FEATURES = Path("data/features")
CODEBOOKS = Path("data/codebooks")
CUES = Path("data/cues")
INTEGRATION = Path("data/integration")
SMOOTHING = Path("data/smoothing")
TRACKING = Path("data/tracking.json")
TABLES = Path("reports/tables")
ACCURACIES = Path("reports/accuracies.csv")
CROSS_VALIDATION = Path("reports/cross_validation.csv")
PAGE = Path("reports/index.html")
