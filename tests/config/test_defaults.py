import shutil
from pathlib import Path

import pytest
from hydra import compose, initialize_config_dir
from omegaconf import OmegaConf

from placecat.config import defaults

CONF = Path(__file__).resolve().parents[2] / "conf"


def by_hydra(conf, choices):
    overrides = [f"{name}={file}" for name, file in choices]
    with initialize_config_dir(str(conf), version_base=None):
        return OmegaConf.to_yaml(compose("config", overrides=overrides))


def merged(conf, choices):
    return OmegaConf.to_yaml(OmegaConf.create(defaults.merge(conf, choices)))


CHOICES = [
    ("dataset", "my_homes"),
    ("classifier@cues.gist.classifier", "nu_svm_sequential"),
    ("classifier@systems.das_551_best.integrator.classifier", "knn"),
    ("cue@cues.hog_y", "sift_tracked"),
    # This contradicts the `override` in nu_svm_sequential.
    ("scheme@cues.spatial_pact_sequential.classifier.scheme", "parallel"),
    ("clustering@codebooks.hog_tracked.tree", "flat_kmeans"),
    ("optional", "embedding"),
]


# There are only a few cases, since Hydra takes seconds for each.
@pytest.mark.slow
@pytest.mark.parametrize("choices", [[], CHOICES], ids=["as it is", "with choices"])
def test_conf_is_merged_as_hydra_merges_it(choices):
    assert merged(CONF, choices) == by_hydra(CONF, choices)


@pytest.fixture
def small(tmp_path):
    """Make a small conf/; return a function that writes its files."""

    def write(**files):
        for name, text in files.items():
            path = tmp_path / f"{name.replace('__', '/')}.yaml"
            path.parent.mkdir(exist_ok=True)
            path.write_text(text)
        return tmp_path

    write(
        config="defaults:\n- kind: one\n- _self_\nkind: {list: [3], number: 1e-3}\n",
        kind__one="defaults:\n- two@_here_\n- _self_\nlist: [1, 2]\nday: 2020-01-01\ndeep: {a: 1}\n",
        kind__two="# Nothing but a mapping.\nnumber: 1e5\ndeep: {a: 0, b: '???'}\nnothing: null\n",
        kind__three="",
    )
    return write


@pytest.mark.parametrize(
    "files",
    [
        {},
        {"config": "defaults:\n- _self_\n- kind: one\nkind: {list: [3], deep: null, nothing: {a: 1}}\n"},
        {"config": "defaults:\n- kind: three\n- /kind/two@a.b\n- /kind@c: one\n- extra: []\n- none: null\n"},
        # The header counts only if the defaults list does not say where the content goes.
        {"kind__one": "# @package _global_\ndefaults:\n- two\n- /kind/two@a\n- _self_\nlist: [1]\n"},
        {"kind__two": "# @package _global_\na: 1\n"},
        {"kind__one": "defaults:\n- /kind/two@inner\n- _self_\ninner: {deep: {a: '???', c: '${kind}'}}\n"},
    ],
)
def test_small_files_are_merged_as_hydra_merges_them(small, files):
    conf = small(**files)
    assert merged(conf, []) == by_hydra(conf, [])


@pytest.mark.parametrize(
    ("files", "choices"),
    [
        ({"kind__two": "# @package other\na: 1\n"}, []),
        ({"kind__two": "# A file.\n# @package _global_\na: 1\n"}, []),
        ({"kind__two": "a: 1\na: 2\n"}, []),
        ({"kind__two": "a: [\n"}, []),
        ({"kind__two": "- 1\n"}, []),
        ({"kind__two": "list: {a: 1}\n"}, []),
        ({"kind__two": "deep: ${kind.list}\n"}, []),
        ({"kind__two": "defaults:\n- one@_here_\n- _self_\n"}, []),
        ({"kind__two": "defaults:\n- /kind/three@_global_\n"}, []),
        ({"kind__two": "defaults:\n- override /other: three\n"}, []),
        ({"kind__one": "defaults:\n- two@_here_\na: 1\n"}, []),
        ({"config": "defaults:\n- kind: [one, two]\n"}, []),
        ({"config": "defaults:\n- optional kind: one\n"}, []),
        ({"config": "defaults:\n- kind: one\n- kind: two\n"}, []),
        ({"config": "defaults:\n- kind: one\n- other: ${kind}\n"}, []),
        ({}, [("kind", "four")]),
        ({}, [("kind", "")]),
        ({}, [("kind", "one"), ("kind", "two")]),
        ({}, [("other", "one")]),
        ({}, [("+kind", "one")]),
    ],
)
def test_rare_and_wrong_cases_are_left_to_hydra(small, files, choices):
    with pytest.raises(defaults.Unusual):
        defaults.merge(small(**files), choices)


def test_conf_has_no_unusual_cases(tmp_path):
    """Otherwise, composing would take seconds."""
    conf = shutil.copytree(CONF, tmp_path / "conf")
    groups = (
        "dataset",
        "compute",
        "optional",
        "classifier@cues.gist.classifier",
        "system@systems.das_551_best",
    )
    for group in groups:
        for path in (conf / group.partition("@")[0]).glob("*.yaml"):
            defaults.merge(conf, [(group, path.stem)])
