"""Compose params.yaml from conf/ with Hydra, exactly as `dvc exp run` does."""

import hashlib
import os
from collections.abc import Sequence
from pathlib import Path

import yaml

from placecat import files, inferred, paths, settings
from placecat.errors import PlacecatError
from placecat.overrides import check as check_overrides

# Folders of conf/ all of whose files are used, and where their content goes.
FOUND = {
    "descriptor/local": "descriptors.local",
    "descriptor/holistic": "descriptors.holistic",
    "codebook": "codebooks",
    "cue": "cues",
    "system": "systems",
    "filter": "filters",
    "split": "splits",
}
# How a codebook without a file of its own is clustered: this file of conf/clustering.
CLUSTERING = "hierarchical_kmeans"
# What params.yaml was composed of.
_COMPOSED = Path("data/params.sha256")


def found(conf: Path = paths.CONF) -> str:
    """List what is used because it is there, as the content of conf/found.yaml.

    Hydra has no pattern for file names in its defaults, and `dvc exp run` composes from files alone. What a
    cue needs and no file describes (:mod:`placecat.inferred`) comes after the files.

    Parameters
    ----------
    conf
        The folder of conf/config.yaml.

    Raises
    ------
    PlacecatError
        As :func:`placecat.inferred.descriptors`.
    """
    lines = [
        "# Written by `placecat params`: every file of these folders. Add a file there, not a line here.",
        "defaults:",
    ]
    for folder_name, package in FOUND.items():
        names = sorted(path.stem for path in (conf / folder_name).glob("*.yaml"))
        lines += [f"- /{folder_name}@{package}.{name}: {name}" for name in names]
    descriptors, codebooks = inferred.descriptors(conf), inferred.codebooks(conf)
    lines += [f"- /clustering@codebooks.{name}.tree: {CLUSTERING}" for name in codebooks]
    content = {"descriptors": descriptors, "codebooks": codebooks}
    own = {name: part for name, part in content.items() if part}
    if own:
        lines += ["- _self_", "# Without a file of their own.", yaml.safe_dump(own, sort_keys=False).rstrip()]
    return "\n".join(lines) + "\n"


def compose(overrides: Sequence[str] = (), conf: Path = paths.CONF) -> str:
    """Compose the settings.

    Parameters
    ----------
    overrides
        Hydra overrides, e.g. ``dataset=my_homes``, ``cues.gist.classifier.base.nu=0.1``.
    conf
        The folder of conf/config.yaml.

    Returns
    -------
    str
        The content of params.yaml.

    Raises
    ------
    PlacecatError
        An override that Hydra cannot read or that names no setting, or a setting without a value.
    """
    from hydra import compose as hydra_compose
    from hydra import initialize_config_dir
    from hydra.errors import HydraException
    from omegaconf import OmegaConf
    from omegaconf.errors import OmegaConfBaseException

    if not (conf / "config.yaml").is_file():
        raise PlacecatError(f"{conf / 'config.yaml'} is missing: run placecat in the project's folder")
    check_overrides(overrides)
    try:
        with initialize_config_dir(str(conf.resolve()), version_base=None):
            config = hydra_compose("config", overrides=list(overrides))
        text: str = OmegaConf.to_yaml(config, resolve=True)
        # Slow to look for otherwise.
        missing = sorted(OmegaConf.missing_keys(config)) if "???" in text else []
        if missing:
            raise PlacecatError(f"setting {missing[0]} has no value: add {missing[0]}=VALUE to the overrides")
    except (HydraException, OmegaConfBaseException) as error:
        lines = [line.strip() for line in str(error).splitlines() if line.strip()]
        raise PlacecatError(f"the settings cannot be composed: {' '.join(lines)}") from None
    return text


def write_params(overrides: Sequence[str] = (), target: Path = paths.PARAMS) -> None:
    """List what is there in conf/found.yaml, compose the settings and write them to params.yaml.

    Nothing is composed where it was from the same files and overrides before, since Hydra takes seconds.

    Raises
    ------
    PlacecatError
        As `found`, `compose` and :func:`placecat.check.check`; params.yaml stays as it was.
    """
    listing = paths.CONF / "found.yaml"
    if (paths.CONF / "config.yaml").is_file():
        content = found()
        if not listing.exists() or listing.read_text(encoding="utf-8") != content:
            files.write_text(listing, content)
    if _COMPOSED.is_file() and _COMPOSED.read_text(encoding="utf-8") == _digest(overrides, target):
        return
    with files.replacing(target) as temporary:
        temporary.write_text(compose(overrides), encoding="utf-8")
        # Here, since pydantic is slow to import.
        from placecat.check import check

        check(settings.load(temporary))
    files.write_text(_COMPOSED, _digest(overrides, target))


def _digest(overrides: Sequence[str], target: Path) -> str:
    """Of all that params.yaml is composed of, and of itself."""
    content = hashlib.sha256(repr(list(overrides)).encode())
    for path in [*sorted(paths.CONF.rglob("*.yaml")), target]:
        own = path.read_bytes() if path.is_file() else b""
        # Another environment gives another value.
        if b"oc.env" in own:
            own = os.urandom(16)
        content.update(f"{path} {hashlib.sha256(own).hexdigest()}".encode())
    return content.hexdigest()
