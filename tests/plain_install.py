"""The environment of `make repro`: the packages of the extras are hidden."""

import re
from importlib import metadata

from project import ROOT

# A process imports this file first. `find_spec` and importlib.metadata no longer find what is hidden.
_HIDE = """
import importlib.metadata
import sys
from importlib.machinery import PathFinder

MODULES, DISTRIBUTIONS = {modules!r}, {distributions!r}


class Visible(PathFinder):
    @classmethod
    def find_spec(cls, name, path=None, target=None):
        return None if name.partition(".")[0] in MODULES else super().find_spec(name, path, target)


sys.meta_path[sys.meta_path.index(PathFinder)] = Visible
find = importlib.metadata.Distribution.from_name.__func__


def from_name(cls, name):
    if name.lower().replace("_", "-") in DISTRIBUTIONS:
        raise importlib.metadata.PackageNotFoundError(name)
    return find(cls, name)


importlib.metadata.Distribution.from_name = classmethod(from_name)
"""


def _plain(name: str) -> str:
    return re.sub(r"[-_.]+", "-", name).lower()


def path_of(folder):
    """Write a module to a folder; Python processes with the folder in PYTHONPATH do not see the extras."""
    locked = re.findall(r"^([\w.-]+)==", (ROOT / "requirements.lock").read_text(), flags=re.MULTILINE)
    kept = {"placecat", "pip", "setuptools", *map(_plain, locked)}
    modules = {
        module
        for module, names in metadata.packages_distributions().items()
        if not any(_plain(name) in kept for name in names)
    }
    hidden = {_plain(one.metadata["Name"]) for one in metadata.distributions()} - kept
    folder.mkdir()
    text = _HIDE.format(modules=sorted(modules), distributions=sorted(hidden))
    (folder / "sitecustomize.py").write_text(text)
    return str(folder)
