"""Stage `model`: a system trained on every home, for `placecat predict`."""

from placecat import paths, settings
from placecat.categorizer import model_file
from placecat.categorizer.train import train
from placecat.stages import run


def main() -> None:
    """Train the system of conf/model on every home; write data/model.placecat."""
    params = settings.load()
    model_file.write(paths.MODEL, train(params, settings.get(params, "model.system")))


if __name__ == "__main__":
    run(main)
