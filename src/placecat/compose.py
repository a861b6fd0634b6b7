"""Compose params.yaml from conf/ with Hydra, exactly as `dvc exp run` does."""

from collections.abc import Sequence
from pathlib import Path

from placecat import files, paths
from placecat.errors import PlacecatError


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
        An override that names no setting, or a setting without a value.
    """
    from hydra import compose as hydra_compose
    from hydra import initialize_config_dir
    from hydra.errors import HydraException
    from omegaconf import OmegaConf
    from omegaconf.errors import OmegaConfBaseException

    if not (conf / "config.yaml").is_file():
        raise PlacecatError(f"{conf / 'config.yaml'} is missing: run placecat in the project's folder")
    try:
        with initialize_config_dir(str(conf.resolve()), version_base=None):
            config = hydra_compose("config", overrides=list(overrides))
        missing = sorted(OmegaConf.missing_keys(config))
        if missing:
            raise PlacecatError(f"setting {missing[0]} has no value: add {missing[0]}=VALUE to the overrides")
        OmegaConf.resolve(config)
    except (HydraException, OmegaConfBaseException) as error:
        lines = [line.strip() for line in str(error).splitlines() if line.strip()]
        raise PlacecatError(f"the settings cannot be composed: {' '.join(lines)}") from None
    return OmegaConf.to_yaml(config)


def write_params(overrides: Sequence[str] = (), target: Path = paths.PARAMS) -> None:
    """Compose the settings and write them to params.yaml."""
    files.write_text(target, compose(overrides))
