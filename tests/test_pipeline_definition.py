"""Compare dvc.yaml and params.yaml with conf/ and the code."""

import ast
import inspect
import shutil
import tempfile
from functools import cache
from pathlib import Path

import pytest
import yaml

from placecat.config import compose
from placecat.settings import Loader, read_yaml
from project import light_conf

ROOT = Path(__file__).resolve().parents[1]
SOURCE = ROOT / "src"
PIPELINE = read_yaml(ROOT / "dvc.yaml")["stages"]
# Modules for finding code and settings, for files and for loops. They affect no numbers.
PLUMBING = (
    "compute",
    "errors",
    "files",
    "lookup",
    "paths",
    "ranges",
    "runs.items",
    "runs.lock",
    "schema.signatures",
    "seeds",
    "sequences.listing",
    "settings",
    "stages",
    "training.fold_file",
)


def program(stage):
    """Return the module that a stage runs with ``python -m MODULE``."""
    module = PIPELINE[stage]["cmd"].split()[2]
    return f"{module}.__main__" if module_file(module).name == "__init__.py" else module


def module_file(module):
    path = SOURCE / Path(*module.split("."))
    return path / "__init__.py" if path.is_dir() else path.with_suffix(".py")


@cache
def imports(module):
    """Return all modules of the project that a module imports anywhere."""
    found = set()
    for node in ast.walk(ast.parse(module_file(module).read_text())):
        if isinstance(node, ast.Import):
            found |= {alias.name for alias in node.names if alias.name.startswith("placecat")}
        elif isinstance(node, ast.ImportFrom) and (node.module or "").startswith("placecat"):
            for alias in node.names:
                inner = f"{node.module}.{alias.name}"
                found.add(inner if module_file(inner).exists() else node.module)
    return found - {"placecat"}


def reached(module):
    seen, todo = set(), [module]
    while todo:
        for found in imports(todo.pop()) - seen:
            if not f"{found}.".startswith(tuple(f"placecat.{name}." for name in PLUMBING)):
                seen.add(found)
                todo.append(found)
    return seen


@pytest.mark.parametrize("stage", list(PIPELINE))
def test_a_stage_depends_on_every_module_it_uses(stage):
    body = PIPELINE[stage]
    listed = [dep for dep in body["deps"] if dep.startswith("src/")]
    for module in {program(stage)} | reached(program(stage)):
        file = module_file(module).relative_to(ROOT).as_posix()
        if file.endswith("__init__.py") and len(module_file(module).read_text().splitlines()) == 1:
            continue
        assert any(file == dep or file.startswith(f"{dep}/") for dep in listed), f"{stage} needs {file}"


def test_every_stage_but_the_frozen_one_is_a_module_of_its_name():
    frozen = {name for name, body in PIPELINE.items() if body.get("frozen")}
    assert frozen == {"render"}
    assert {name: program(name) for name in PIPELINE if name not in frozen} == {
        name: f"placecat.stages.{name}" for name in PIPELINE if name not in frozen
    }


@pytest.mark.parametrize("stage", list(PIPELINE))
def test_the_dependencies_of_a_stage_exist(stage):
    for dep in PIPELINE[stage]["deps"]:
        if dep.startswith(("src/", "conf/")):
            assert (ROOT / dep).exists(), dep


def test_params_are_what_conf_composes():
    assert read_yaml(ROOT / "params.yaml") == yaml.load(compose.compose(conf=ROOT / "conf"), Loader=Loader), (
        "run `placecat params` and commit params.yaml"
    )


NOT_LEARNING = ("title", "schemes", "extra", "cross_validate")
OWN = {
    "parallel": {"combination", "exclusive", "reliability", "prior", "reliability_smoothing", "uncertainty"},
    "sequential": {"order", "training", "decision", "output"},
}


def schemes_compared():
    """Yield the settings of both schemes wherever the thesis compares them."""
    params = read_yaml(ROOT / "params.yaml")
    cues = params["cues"]
    whole = {
        scheme: {key: value for key, value in cues[name].items() if key not in NOT_LEARNING}
        for scheme, name in (("parallel", "spatial_pact"), ("sequential", "spatial_pact_sequential"))
    }
    yield "table_29", whole["parallel"], whole["sequential"]
    schemes = params["toy"]["schemes"]
    yield "toy", {"classifier": schemes["parallel"]}, {"classifier": schemes["sequential"]}
    files = {
        name: _composed(f"classifier@cues.gist.classifier={name}") for name in ("nu_svm", "nu_svm_sequential")
    }
    yield "conf/classifier", files["nu_svm"]["cues"]["gist"], files["nu_svm_sequential"]["cues"]["gist"]


@pytest.mark.parametrize("compared", ["table_29", "toy", "conf/classifier"])
def test_the_two_schemes_differ_only_in_the_scheme(compared):
    parallel, sequential = next((one, other) for name, one, other in schemes_compared() if name == compared)
    own = []
    for name, settings in (("parallel", parallel), ("sequential", sequential)):
        scheme = settings["classifier"]["scheme"]
        assert OWN[name] <= set(scheme)
        shared = {key: value for key, value in scheme.items() if key not in {"name", *OWN[name]}}
        own.append(settings | {"classifier": settings["classifier"] | {"scheme": shared}})
    assert own[0] == own[1]


def test_the_sequential_scheme_follows_changes_to_the_parallel_one():
    changed = "cues.spatial_pact.classifier.scheme.sigmoid_weights=balanced"
    nu = "cues.spatial_pact.classifier.base.nu=0.1"
    cue = _composed(changed, nu)["cues"]["spatial_pact_sequential"]
    assert cue["classifier"]["scheme"]["sigmoid_weights"] == "balanced"
    assert cue["classifier"]["base"]["nu"] == 0.1


@pytest.mark.parametrize("stage", list(PIPELINE))
def test_no_setting_reaches_a_shell(stage):
    """DVC inserts settings into commands without quotes, so a home `home 1;touch X` would run touch."""
    assert "$" not in PIPELINE[stage]["cmd"]


def test_there_are_few_stages():
    # The time that DVC takes per stage grows with their number, and each stage starts Python again.
    assert len(PIPELINE) <= 21
    assert not any("foreach" in body for body in PIPELINE.values())
    assert len((ROOT / "dvc.yaml").read_text().splitlines()) <= 250
    assert (ROOT / "params.yaml").stat().st_size <= 26 * 1024


def test_new_files_in_conf_are_found(tmp_path):
    """A cue is found without being listed anywhere."""
    conf = tmp_path / "conf"
    shutil.copytree(ROOT / "conf", conf)
    shutil.copy(conf / "cue/hog_y.yaml", conf / "cue/hog_again.yaml")
    (conf / "found.yaml").write_text(compose.found(conf))
    composed = yaml.load(compose.compose(conf=conf), Loader=Loader)
    params = read_yaml(ROOT / "params.yaml")
    assert composed["cues"]["hog_again"] == params["cues"]["hog_y"]


def test_found_yaml_in_git_is_up_to_date():
    assert (ROOT / "conf/found.yaml").read_text() == compose.found(ROOT / "conf"), "run `placecat params`"


@cache
def _light_conf():
    return light_conf(Path(tempfile.mkdtemp()) / "conf")


def _composed(*overrides):
    return yaml.load(compose.compose(overrides, conf=_light_conf()), Loader=Loader)


def settings_in_code():
    """Yield each part of params.yaml, the function or class with these settings, and its other parameters."""
    from placecat.cues import estimators
    from placecat.evaluation.quality import home_quality
    from placecat.fusion.smoothing import fit
    from placecat.learning.toy_circles import toy_circles
    from placecat.vision import discovery
    from placecat.vision.attention import compute_maps
    from placecat.vision.information import information
    from placecat.vision.orientation import orientation_maps
    from placecat.vision.regions import accept, select_regions
    from placecat.vision.saliency import saliency
    from placecat.vision.spectral_residual import spectral_residual
    from placecat.vision.tracking import RegionTracker

    params = read_yaml(ROOT / "params.yaml")
    for section, functions in {
        "attention": (compute_maps, orientation_maps, spectral_residual),
        "regions": (select_regions, accept, saliency),
        "information": (information,),
    }.items():
        in_code = set().union(*map(discovery.settings_of, functions))
        assert set(params[section]) == in_code, section
    for kind in ("local", "holistic"):
        for name, settings in params["descriptors"][kind].items():
            module, own = discovery.entry(kind, name, settings)
            given = {"maps", "regions", "frame"}
            yield f"descriptors.{kind}.{name}", own, module.describe, given
    tracking = {name: value for name, value in params["tracking"].items() if name != "descriptors"}
    yield "tracking", tracking, RegionTracker, set()
    for path in sorted((ROOT / "conf/clustering").glob("*.yaml")):
        clustering = yaml.safe_load(path.read_text())
        estimator = type(estimators.build(clustering, path.stem))
        options = {key: value for key, value in clustering.items() if key != "name"}
        yield path.stem, options, estimator, {"seed", "numbers"}
    read = {
        path.relative_to(ROOT / "conf").as_posix(): yaml.safe_load(path.read_text())
        for folder in ("classifier", "scheme")
        for path in sorted((ROOT / "conf" / folder).glob("*.yaml"))
    }
    for file, content in read.items():
        options = content.get("base") if file.startswith("classifier/") else content
        # A file without a name is a variant of another one.
        if options and "name" in options:
            estimator = type(estimators.build({"name": options["name"]}, file))
            settings = {key: value for key, value in options.items() if key not in ("name", "defaults")}
            given = {"n_values", "n_jobs", "base", "codebook", "n_clusters", "seed"}
            # The cache size of libsvm affects only the speed.
            yield file, settings, estimator, given | {"cache_mb"}
    given = {"n_classes"}
    given |= {f"training_{part}" for part in ("sequences", "frame_rates", "proba", "truth")}
    lists = ("cues", "filtered")
    smoothing = {name: value for name, value in params["smoothing"].items() if name not in lists}
    yield "toy.points", params["toy"]["points"], toy_circles, {"n", "seed"}
    yield "smoothing", smoothing, fit, given
    yield "probabilities", params["probabilities"], home_quality, {"truth", "proba", "sequences"}


@pytest.mark.parametrize(
    ("name", "values", "function", "given"), [pytest.param(*part, id=part[0]) for part in settings_in_code()]
)
def test_settings_match_the_parameters_in_the_code(name, values, function, given):
    names = set(inspect.signature(function).parameters) - given
    assert set(values) == names, name


def test_no_setting_has_a_name_that_dvc_leaves_out_of_its_run_cache():
    """DVC takes these names for file sizes, so a changed value would get the results of the old one."""

    def names(content):
        for name, inner in content.items() if isinstance(content, dict) else ():
            yield from (name, *names(inner))

    params = read_yaml(ROOT / "params.yaml")
    assert not {"size", "nfiles"} & set(names(params))
