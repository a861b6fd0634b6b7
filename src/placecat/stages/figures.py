"""Stage `figures`: draw the figures of the thesis and additional ones, if the data allow it."""

import logging

from placecat import files, paths, settings
from placecat.errors import PlacecatError, SettingError
from placecat.report import figures
from placecat.report.run import Run
from placecat.stages import run


def main() -> None:
    """Write reports/figures/: PNGs, PDFs, and figures.json with captions and reasons for missing figures."""
    of_run = Run(settings.load())
    entries = []
    with files.replacing(paths.FIGURES) as folder:
        folder.mkdir(parents=True)
        for name in figures.names():
            entry = {"name": name, "number": figures.number(name), "title": figures.caption(name)}
            try:
                figures.render(name, of_run, folder / f"{name}.png")
                entries.append(entry | {"file": f"{name}.png", "reason": None})
            except SettingError:
                raise
            except PlacecatError as error:
                # This figure cannot be drawn from these data.
                logging.warning("%s is left out: %s", name, error)
                entries.append(entry | {"file": None, "reason": str(error)})
        files.write_json(folder / "figures.json", entries)


if __name__ == "__main__":
    run(main)
