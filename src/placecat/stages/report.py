"""Stage `report`: one page with every table."""

import pandas as pd

from placecat import files, listing, paths, settings
from placecat.reporting.page import page_html
from placecat.stages import run


def main() -> None:
    """Write reports/index.html."""
    params = settings.load()
    dataset = settings.get(params, "dataset")
    tables = [(table, _read_table(name)) for name, table in settings.get(params, "tables").items()]
    frames = {}
    for home in dataset["homes"]:
        labels = listing.read_labels(home)
        frames[home] = {
            place: int((labels == number).sum()) for number, place in enumerate(dataset["classes"])
        }
        frames[home]["unlabelled"] = int((labels < 0).sum())
    files.write_text(paths.PAGE, page_html(tables, dataset, frames))


def _read_table(name: str) -> pd.DataFrame:
    text = dict.fromkeys(("group", "row", "column", "note"), str)
    return pd.read_csv(paths.TABLES / f"{name}.csv", dtype=text).fillna(dict.fromkeys(text, ""))


if __name__ == "__main__":
    run(main)
