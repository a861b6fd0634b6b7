"""The settings that a search starts with; its result is at least as good as these."""

from collections.abc import Mapping, Sequence
from typing import Any

from omegaconf import DictConfig, OmegaConf

from placecat.errors import PlacecatError

# Source of the first start.
SETTINGS = "the settings without a search"


def find(keys: Sequence[str], config: DictConfig, params: Mapping[str, Any]) -> dict[str, dict[str, Any]]:
    """Find the settings to start with; map each start's source to its values of the searched keys.

    `config` is the first start: the experiment composed without the searched settings, but with Hydra's.
    Raises PlacecatError for a key that it lacks. Cues of `params` that have the experiment's descriptor and
    classifier but other settings are also starts, since conf/cue has the thesis's best settings.
    """
    first = {key: _value(key, config) for key in keys}
    found = {SETTINGS: first}
    for name, cue in params.get("cues", {}).items():
        own = first | _of_cue(cue, params, config, keys)
        if own not in found.values():
            found[f"conf/cue/{name}.yaml"] = own
    return found


def _value(key: str, config: DictConfig) -> Any:
    """Return a setting's value, or a group's chosen option."""
    choices = config.hydra.runtime.choices
    if key in choices:
        return choices[key]
    missing = object()
    found = OmegaConf.select(config, key, default=missing)
    if found is missing:
        raise PlacecatError(f"{key} cannot be searched: the experiment has no such setting")
    return OmegaConf.to_container(found) if OmegaConf.is_config(found) else found


def _of_cue(
    cue: Mapping[str, Any], params: Mapping[str, Any], config: DictConfig, keys: Sequence[str]
) -> dict[str, Any]:
    """Return a cue's searched classifier settings; {} if its descriptor or classifier is another one."""
    codebook = cue.get("codebook")
    descriptor = cue["descriptor"] if codebook is None else params["codebooks"][codebook]["descriptor"]
    wanted = {f"descriptor.{name}": value for name, value in descriptor.items()}
    if descriptor["kind"] == "local":
        wanted["descriptor.tracked"] = descriptor.get("tracked", False)
    wanted["classifier.model"] = cue["classifier"]["model"]
    wanted["classifier.base.name"] = cue["classifier"]["base"]["name"]
    if any(OmegaConf.select(config, key) != value for key, value in wanted.items()):
        return {}
    own = OmegaConf.create({"classifier": cue["classifier"]})
    found = {key: OmegaConf.select(own, key) for key in keys if key.startswith("classifier.")}
    return {key: value for key, value in found.items() if value is not None}
