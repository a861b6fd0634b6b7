"""Write the demo's page: its table, timeline and clip in one file that works offline."""

import base64
from pathlib import Path

import pandas as pd

from placecat import files
from placecat.report.embed import embed
from placecat.templates import environment

# The command that trains on all frames.
COMPLETE = "make repro"


def write(
    target: Path, table: pd.DataFrame, home: str, training_homes: int, timeline: Path, clip: Path
) -> None:
    """Write the page about the test home, with a table in percent, a PNG timeline and a WebM clip."""
    rows = [
        (name, ["" if pd.isna(value) else f"{value:.0f}" for value in values])
        for name, *values in table.itertuples()
    ]
    video = base64.b64encode(clip.read_bytes()).decode("ascii")
    text = (
        environment("placecat.demo")
        .get_template("demo.html.j2")
        .render(
            columns=list(table.columns),
            rows=rows,
            home=home.replace("_", " "),
            training_homes=training_homes,
            timeline=embed(timeline.read_bytes()),
            clip=f"data:video/webm;base64,{video}",
            complete=COMPLETE,
        )
    )
    files.write_text(target, text)
