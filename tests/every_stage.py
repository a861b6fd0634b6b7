"""Run every stage of the pipeline in the current folder, one after the other in this process, without DVC.

``python every_stage.py`` works like a complete `dvc repro`, but Python starts only once.
"""

import importlib
from pathlib import Path

import yaml

import placecat.stages  # noqa: F401  before NumPy: it chooses the OpenBLAS kernels


def main():
    pipeline = yaml.safe_load(Path("dvc.yaml").read_text())["stages"]
    for name, body in pipeline.items():
        if body.get("frozen") or name == "tracking":
            continue
        importlib.import_module(f"placecat.stages.{name}").main()


if __name__ == "__main__":
    main()
