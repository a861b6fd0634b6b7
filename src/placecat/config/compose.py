"""Compose params.yaml from conf/ with Hydra, exactly as `dvc exp run` does."""

import hashlib
import os
import re
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import yaml

from placecat import files, paths, settings
from placecat.config import inferred
from placecat.config.overrides import check as check_overrides
from placecat.config.overrides import unknown_setting
from placecat.errors import PlacecatError, did_you_mean
from placecat.runs import lock

if TYPE_CHECKING:
    from omegaconf import DictConfig

# Folders of conf/ in which every file is used, and the section that receives the contents of its files.
FOUND = {
    "descriptor/local": "descriptors.local",
    "descriptor/holistic": "descriptors.holistic",
    "codebook": "codebooks",
    "cue": "cues",
    "system": "systems",
    "filter": "filters",
    "split": "splits",
}
# The file in conf/clustering for codebooks that have no file in conf/codebook.
CLUSTERING = "hierarchical_kmeans"
# A file with a checksum of params.yaml and its sources.
_COMPOSED = Path("data/params.sha256")


def found(conf: Path = paths.CONF) -> str:
    """Return the contents of conf/found.yaml, which lists every file in the folders of `FOUND`.

    A Hydra defaults list cannot contain a file pattern, and `dvc exp run` composes only from files.
    Inferred settings come last. Raises the same errors as :mod:`placecat.config.inferred`.
    """
    lines = [
        "# `placecat params` writes this list of all files in these folders. To extend it, add a file.",
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
        lines += ["- _self_", "# Settings without a file.", yaml.safe_dump(own, sort_keys=False).rstrip()]
    return "\n".join(lines) + "\n"


def compose(overrides: Sequence[str] = (), conf: Path = paths.CONF) -> str:
    """Compose the settings in conf/config.yaml with Hydra overrides; return the contents of params.yaml.

    Overrides look like ``dataset=my_homes`` or ``cues.gist.classifier.base.nu=0.1``. Raises PlacecatError for
    an unreadable override, an unknown setting, or a setting without a value.
    """
    from omegaconf import OmegaConf
    from omegaconf.errors import OmegaConfBaseException

    from placecat.config import defaults

    if not (conf / "config.yaml").is_file():
        raise PlacecatError(f"{conf / 'config.yaml'} is missing: run placecat in the project folder")
    check_overrides(overrides)
    choices: list[tuple[str, str]] = []
    values = []
    for override in overrides:
        name, _, file = override.partition("=")
        if (conf / name.lstrip("+~").partition("@")[0]).is_dir():
            choices.append((name, file))
        else:
            values.append(override)
    try:
        try:
            content = defaults.merge(conf, choices)
            config = _by_hydra(values, content, f"{conf}/") if values else OmegaConf.create(content)
        except defaults.Unusual:
            config = _by_hydra(overrides, conf, f"{conf}/")
        text: str = OmegaConf.to_yaml(config, resolve=True)
        # Search for the marker first, since `missing_keys` is slow.
        missing = sorted(OmegaConf.missing_keys(config)) if "???" in text else []
        if missing:
            raise PlacecatError(f"setting {missing[0]} has no value: add {missing[0]}=VALUE to the overrides")
    except OmegaConfBaseException as error:
        raise refusal(error) from None
    return text


def overridden(content: dict[str, Any], overrides: Sequence[str], where: str) -> dict[str, Any]:
    """Apply Hydra overrides such as ``fps=10.0`` to plain settings outside params.yaml.

    `where` is what messages call the settings file. Raises PlacecatError for an unreadable override or
    an unknown setting.
    """
    from omegaconf import OmegaConf
    from omegaconf.errors import OmegaConfBaseException

    check_overrides(overrides)
    try:
        result: dict[str, Any] = OmegaConf.to_container(_by_hydra(overrides, content, where), resolve=True)  # type: ignore[assignment]
    except OmegaConfBaseException as error:
        raise refusal(error) from None
    return result


def _by_hydra(overrides: Sequence[str], source: Path | dict[str, Any], where: str) -> "DictConfig":
    """Let Hydra apply overrides to `source` (merged settings, or a folder), which messages call `where`."""
    from hydra import compose as hydra_compose
    from hydra import initialize, initialize_config_dir
    from hydra.core.config_store import ConfigStore
    from hydra.errors import HydraException, MissingConfigException

    try:
        if isinstance(source, Path):
            with initialize_config_dir(str(source.resolve()), version_base=None):
                return hydra_compose("config", overrides=list(overrides))
        ConfigStore.instance().store("merged", source)
        with initialize(version_base=None):
            return hydra_compose("merged", overrides=list(overrides))
    except MissingConfigException as error:
        raise refusal(error, where) from None
    except (HydraException, yaml.YAMLError) as error:
        unknown = unknown_setting(overrides, source, where) if isinstance(source, dict) else None
        raise refusal(unknown or error) from None
    except ValueError as error:
        # Hydra's message does not name the override.
        raise PlacecatError(f"the settings cannot be composed from {' '.join(overrides)}: {error}") from None


def refusal(error: Exception | str, where: str = "") -> PlacecatError:
    """Turn an error from Hydra or OmegaConf, or its text, into a message on one line.

    `where` is what the message calls the folder of the settings.
    """
    from hydra.errors import MissingConfigException

    text = str(error)
    if isinstance(error, MissingConfigException) and error.missing_cfg_file and error.options is not None:
        group, _, name = error.missing_cfg_file.rpartition("/")
        there = ", ".join(error.options)
        text = f"{where}{group} has no {name!r}{did_you_mean(name, error.options)} (available: {there})"
    # Hydra's search path and its general advice on unknown settings do not help the user.
    text = re.split("Config search path:|To append to your config", text)[0]
    text = re.sub(r"^Could not override '(.*)'\.$", r"there is no setting '\1'", text.strip())
    lines = [line.strip() for line in text.splitlines() if line.strip()]
    return PlacecatError(f"the settings cannot be composed: {' '.join(lines)}")


@lock.alone()
def write_params(overrides: Sequence[str] = (), target: Path = paths.PARAMS) -> None:
    """Write conf/found.yaml, compose the settings and write them to params.yaml.

    Does nothing if files and overrides have not changed since the last call. Raises PlacecatError if a run is
    in progress, or if `found`, `compose`, :func:`placecat.config.check.check` or
    :func:`placecat.config.tables.check` raises one. On an error, params.yaml is left unchanged.
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
        # Imported late: importing pydantic is slow.
        from placecat.config import tables as checks
        from placecat.config.check import check

        params = settings.load(temporary)
        check(params)
        checks.check(params)
    files.write_text(_COMPOSED, _digest(overrides, target))


def _digest(overrides: Sequence[str], target: Path) -> str:
    """Return a checksum of the overrides, params.yaml, its sources and the table definitions."""
    content = hashlib.sha256(repr(list(overrides)).encode())
    read = [*paths.CONF.rglob("*.yaml"), *paths.TABLE_DEFINITIONS.rglob("*.yaml")]
    for path in [*sorted(read), target]:
        own = path.read_bytes() if path.is_file() else b""
        # The settings depend on environment variables, so the checksum must never match.
        if b"oc.env" in own:
            own = os.urandom(16)
        content.update(f"{path} {hashlib.sha256(own).hexdigest()}".encode())
    return content.hexdigest()
