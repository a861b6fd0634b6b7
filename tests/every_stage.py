"""Run every stage of the pipeline in the current folder, one after the other in this process, without DVC.

`python every_stage.py`: as `dvc repro` from nothing, but Python starts once.
"""

import importlib
from pathlib import Path

import yaml

import placecat.stages  # noqa: F401  before NumPy: it chooses the kernels of OpenBLAS


def items(body, params):
    """What a stage runs for: each item of its loop, or once."""
    if "foreach" not in body:
        return [()]
    value = params
    for part in body["foreach"].strip("${}").split("."):
        value = value[part]
    return [(item,) for item in value]


def main():
    params = yaml.safe_load(Path("params.yaml").read_text())
    pipeline = yaml.safe_load(Path("dvc.yaml").read_text())["stages"]
    for name, body in pipeline.items():
        if body.get("frozen") or name == "tracking":
            continue
        stage = importlib.import_module(f"placecat.stages.{name}")
        for item in items(body, params):
            stage.main(*item)


if __name__ == "__main__":
    main()
