"""Stage `model`: train a system on all homes, for `placecat predict`."""

from placecat import paths, settings
from placecat.categorizer import held_out, model_file
from placecat.categorizer.train import measured, train
from placecat.stages import run


def main() -> None:
    """Train the system named in conf/model on all homes; write data/model.placecat."""
    params = settings.load()
    name, seed = (settings.get(params, f"model.{setting}") for setting in ("system", "seed"))
    trained = measured(train(params, name), params, held_out.of_stages(params, name, seed))
    model_file.write(paths.MODEL, trained)


if __name__ == "__main__":
    run(main)
