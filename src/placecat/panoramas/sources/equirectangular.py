"""Equirectangular pictures from 360-degree cameras, and a table of the pictures' rooms."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from placecat.panoramas.panorama import Panorama
from placecat.panoramas.sources.table import read_table


def read(root: Path, settings: Mapping[str, Any]) -> list[Panorama]:
    """List the panoramas in a folder; see `placecat.panoramas.sources.read`."""
    return read_table(root, settings, lambda file: [file])
