"""The settings with an addition from conf/optional."""

import shutil
import tempfile
from functools import cache
from pathlib import Path

import yaml

from placecat.config.compose import compose
from placecat.settings import Loader
from project import light_conf


@cache
def with_optional(name):
    """Compose all settings with ``optional=name``."""
    folder = Path(tempfile.mkdtemp())
    try:
        light = yaml.load(compose([f"optional={name}"], conf=light_conf(folder / "conf")), Loader=Loader)
    finally:
        shutil.rmtree(folder)
    return light
