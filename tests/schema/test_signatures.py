"""Names of missing code and unknown settings are rejected immediately."""

import subprocess
import sys

import pytest
from changed_settings import MISSING, PARAMS, ROOT, changed, refused

from placecat import schema
from placecat.config.compose import write_params
from placecat.errors import PlacecatError
from placecat.schema import signatures
from project import light_conf

PARTS = [
    "cues.gist.classifier",
    "cues.gist.classifier.base",
    "cues.gist.classifier.scheme",
    "cues.spatial_pact.classifier.reduction",
    "cues.hog_y.classifier",
    "cues.hog_y.classifier.base",
    "codebooks.hog_y.tree",
    "systems.das_551_best.integrator.classifier",
    "systems.das_551_best.integrator.classifier.base",
    "splits.university.integrator.classifier.scheme",
    "toy.schemes.parallel",
    "toy.schemes.sequential.scheme",
    "descriptors.local.hog",
    "descriptors.local.centrist_laplacian",
    "descriptors.holistic.gist",
    "region_variants.variants.as_used.regions",
    "figures.clusters",
    "figures.figure_09",
    "figures.figure_16",
    "figures.figure_reliability",
]


def test_the_settings_in_git_are_valid():
    signatures.check(PARAMS)
    signatures.check({})


@pytest.mark.parametrize("part", PARTS)
def test_an_unknown_setting_is_refused(part):
    params = changed(f"{part}.nonsense", 1)
    schema.check(params)
    message = refused(signatures.check, params)
    assert message.startswith(f"{part} has no setting 'nonsense' (valid: ")


@pytest.mark.parametrize(
    ("setting", "value", "message"),
    [
        ("cues.gist.classifier.model", "svm", r"cues\.gist\.classifier\.model 'svm' does not exist"),
        ("cues.gist.classifier.model", None, r"cues\.gist\.classifier\.model None does not exist"),
        ("cues.gist.classifier.base.name", "nu_svn", r"base\.name 'nu_svn' .*did you mean 'nu_svm'"),
        ("cues.gist.classifier.base.name", "kernels", r"base\.name 'kernels' is not an estimator"),
        (
            "cues.gist.classifier.base.name",
            "discrete_bayes",
            r"base\.name 'discrete_bayes' is not an estimator",
        ),
        ("cues.hog_y.classifier.base.n_values", 3, r"classifier\.base has no setting 'n_values'"),
        ("codebooks.hog_y.tree.seed", 3, r"codebooks\.hog_y\.tree has no setting 'seed'"),
        ("dataset.layout", "vidoe", r"dataset\.layout 'vidoe' does not exist; did you mean 'video'"),
        ("splits.university.dataset.layout", "base", r"splits\.university\.dataset\.layout 'base' does not"),
        ("descriptors.local.hog.descriptor", "hug", r"descriptors\.local\.hog: local descriptor 'hug' does"),
        ("figures.figure_08", {}, r"figures: 'figure_08' does not exist"),
    ],
)
def test_missing_code_and_unknown_settings_are_rejected(setting, value, message):
    refused(signatures.check, changed(setting, value), message)


@pytest.mark.parametrize("setting", ["cues.hog_y.classifier.clusters", "cues.gist.classifier.base.name"])
def test_required_settings_must_be_present(setting):
    parent, _, name = setting.rpartition(".")
    refused(signatures.check, changed(setting, MISSING), rf"{parent} needs the setting '{name}'")


def test_composing_rejects_unknown_settings(tmp_path, monkeypatch):
    light_conf(tmp_path / "conf")
    monkeypatch.chdir(tmp_path)
    with pytest.raises(PlacecatError, match=r"cues\.gist\.classifier\.base has no setting 'nonsense'"):
        write_params(["++cues.gist.classifier.base.nonsense=1"])
    assert {path.name for path in tmp_path.iterdir()} == {"conf"}


def test_no_large_library_is_imported():
    code = (
        "import sys; from placecat import settings; from placecat.schema import signatures; "
        "signatures.check(settings.load()); "
        "print({'sklearn', 'scipy', 'cv2', 'pandas', 'matplotlib', 'numpy'} & set(sys.modules))"
    )
    command = [sys.executable, "-c", code]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "set()"
