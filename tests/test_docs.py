"""README.md and docs/ have only existing commands, numbers from result files and working links."""

import importlib.util
import json
import re
import shlex
import subprocess
import sys
import tomllib
from functools import cache

import numpy as np
import pytest
import yaml
from omegaconf import OmegaConf

import placecat
from placecat import settings
from placecat.__main__ import _parser
from placecat.experiment import options, sweep
from placecat.panoramas.command import read_settings
from placecat.settings import read_yaml
from placecat_homes.__main__ import _parser as homes_parser
from project import ROOT

_SPEC = importlib.util.spec_from_file_location("fill", ROOT / "docs/fill.py")
fill = importlib.util.module_from_spec(_SPEC)
_SPEC.loader.exec_module(fill)

PAGES = {name: (ROOT / name).read_text(encoding="utf-8") for name in (*fill.PAGES, "CONTRIBUTING.md")}
FENCE = re.compile(r"^```(\w*)\n(.*?)^```$", re.DOTALL | re.MULTILINE)
# External commands that a test cannot run, and why.
ELSEWHERE = {
    "dask": "starts a Dask server",
    "git": "changes a repository",
    "mkdir": "makes a folder for downloaded data",
    "tar": "unpacks downloaded data",
    "unzip": "reads a trained model, which `make repro` writes",
    "pre-commit": "is optional",
    "ruff": "is run by `make lint`",
    ".": "activates .venv",
}
ADDED = ("SET=dataset=rooms", "classifier=rvm", "classifier=nearest_mean")
MAKEFILE = (ROOT / "Makefile").read_text()


def commands():
    """Return pairs of a page and a command: each line of a shell block, and commands in running text."""
    found = []
    for page, text in PAGES.items():
        lines = [line for kind, block in FENCE.findall(text) if kind == "sh" for line in block.splitlines()]
        spans = re.findall(r"`([^`\n]+)`", FENCE.sub("", text))
        lines += [
            one for one in spans if re.match(r"(make|placecat|placecat-homes|dvc|pip|python) [\w-]", one)
        ]
        for line in dict.fromkeys(lines):
            words = shlex.split(line, comments=True)
            while "&&" in words:
                found.append((page, words[: words.index("&&")]))
                words = words[words.index("&&") + 1 :]
            found.append((page, words))
    return found


def check_settings(overrides):
    """Check that every chosen file exists, and that every setting is in params.yaml or in a chosen file."""
    params = settings.load(ROOT / "params.yaml")
    pairs = [one.partition("=")[::2] for one in overrides if one != "..."]
    files = {
        name: ROOT / f"conf/{name}/{value}.yaml" for name, value in pairs if (ROOT / "conf" / name).is_dir()
    }
    for path in files.values():
        assert path.is_file(), path
        content = yaml.safe_load(path.read_text())
        own = content if path.parent.name == "optional" else {path.parent.name: content}
        params = OmegaConf.to_container(OmegaConf.merge(params, own))
    for name, _ in pairs:
        if name not in files:
            settings.get(params, name)


def check_make(words):
    target, *variables = words
    assert re.search(rf"^{target}:", MAKEFILE, re.MULTILINE), f"no target {target}"
    for name, _, value in (one.partition("=") for one in variables):
        assert re.search(rf"^{name} \?=", MAKEFILE, re.MULTILINE), f"no variable {name}"
        if name == "SET":
            check_settings(shlex.split(value))


def check_placecat(words):
    if words[0] in ("experiment", "search"):
        check_hydra(words[0], *words[1:])
    elif len(words) > 1:
        chosen = _parser().parse_args(words)
        check_settings(getattr(chosen, "overrides", ()))
        read_settings(getattr(chosen, "changes", ()))
    else:
        with pytest.raises(SystemExit, match=r"^0$"):
            _parser().parse_args([*words, "--help"])


@cache
def check_hydra(command, *words):
    from hydra import compose as hydra_compose
    from hydra import initialize_config_dir
    from hydra.core.global_hydra import GlobalHydra

    overrides = [one for one in words if not one.startswith("-")]
    if not overrides:
        return
    if command == "search" and overrides and "=" not in overrides[0]:
        overrides = ["hydra/sweeper=optuna", f"+search={overrides[0]}", *overrides[1:]]
    options.register(ROOT / "conf")
    with initialize_config_dir(str(ROOT / "conf"), version_base="1.3"):
        own = [one for one in overrides if one.startswith(("hydra", "+search"))]
        rest = [one for one in overrides if one not in own]
        (first, *_), _ = sweep.grid(rest, GlobalHydra.instance().config_loader())
        hydra_compose("experiment", overrides=[*own, *first])


def check_dvc(words):
    from dvc.cli.parser import get_main_parser

    chosen = get_main_parser().parse_args(words)
    if words[0] == "repro":
        stages = read_yaml(ROOT / "dvc.yaml")["stages"]
        assert set(chosen.targets) <= set(stages)
    check_settings(getattr(chosen, "set_param", None) or ())


def check_pip(words):
    extras = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]["optional-dependencies"]
    assert words[0] == "install"
    for extra in re.findall(r"\.\[(\w+)\]", " ".join(words)):
        assert extra in extras


def check_python(words):
    if words[0] == "-m":
        assert importlib.util.find_spec(words[1]) or words[1] == "venv"
    else:
        assert (ROOT / words[0]).is_file()


@pytest.mark.parametrize(
    ("page", "words"), commands(), ids=lambda one: one if isinstance(one, str) else "_".join(one)
)
def test_every_command_exists(page, words, monkeypatch):
    monkeypatch.chdir(ROOT)
    words = words or ["."]
    name = words[0].removeprefix(".venv/bin/")
    # tests/test_adding.py tests the additions in docs/adding.md.
    if name in ELSEWHERE or (page == "docs/adding.md" and words[-1] in ADDED):
        return
    {
        "make": check_make,
        "placecat": check_placecat,
        "dvc": check_dvc,
        "pip": check_pip,
        "python": check_python,
        "placecat-homes": homes_parser().parse_args,
    }[name](words[1:])


def test_every_code_block_has_a_tested_language():
    kinds = {(page, kind) for page, text in PAGES.items() for kind, _ in FENCE.findall(text)}
    assert {kind for _, kind in kinds} <= {"sh", "python", "yaml", "text"}
    # tests/test_adding.py follows docs/adding.md.
    assert {page for page, kind in kinds if kind == "yaml"} <= {"docs/adding.md"}
    with_python = {page for page, kind in kinds if kind == "python"}
    assert with_python == {"docs/adding.md", "docs/robots.md", "docs/usage.md"}


def blocks(page):
    return [block for kind, block in FENCE.findall(PAGES[page]) if kind == "python"]


def test_the_learners_and_the_vision_are_used_as_the_page_says():
    """The first Python block on the page is run by tests/training/test_system.py."""
    _, code = blocks("docs/usage.md")
    rng = np.random.default_rng(0)
    y = np.repeat([0, 1], 20)
    X = rng.random((40, 3)) + y[:, None]
    names = {"X": X, "y": y, "X_new": X[:2], "frame": rng.integers(0, 256, (120, 160, 3), dtype=np.uint8)}
    exec(compile(code, "docs/usage.md", "exec"), names)
    assert names["model"].predict_proba(X).shape == (40, 2)
    assert len(names["regions"])


def test_a_robot_feeds_frames_as_the_page_says(monkeypatch, capsys):
    import cv2
    from made_system import CLASSES, frames, make_system

    from placecat.categorizer import Categorizer

    class Camera:
        def __init__(self, number):
            self.frames = iter(frames(3))

        def read(self):
            frame = next(self.frames, None)
            return frame is not None, frame

    categorizer = Categorizer(make_system())
    monkeypatch.setattr(Categorizer, "load", lambda path, resize: categorizer)
    monkeypatch.setattr(cv2, "VideoCapture", Camera)
    (code,) = blocks("docs/robots.md")
    exec(compile(code, "docs/robots.md", "exec"), {})
    lines = capsys.readouterr().out.splitlines()
    assert len(lines) == 3 + len(categorizer.visits())
    assert all(line.split()[0] in (*CLASSES, "unknown") for line in lines)
    # The categorizer has the same result for the first frame if it is called directly.
    categorizer.reset()
    assert lines[0].split()[2] == categorizer.update(frames(1)[0]).place


# Numbers that are not results, such as versions, sections of the thesis, requested shares and settings.
GIVEN = {
    "README.md": "3.11 3.13 4.0",
    "data/README.md": "4.0 4.1 4.8 4.9 4.10 4.5 6 2 20 35 128 300 8,500",
    "docs/adding.md": "1.0",
    "docs/benchmarks.md": "20,000 294 513,370 151 3.2",
    "docs/cluster.md": "452 430 3.5 25 105 71",
    "docs/own-data.md": "4.9 2.2 25.9 32,937 8,200 69,455 17,400 10.7",
    "docs/results.md": "2 3.3 0.7 1.4",
    # These are from simulations; see tests/replication.
    "docs/replication.md": "2 3 0.8 1.63 4.89 1.7 4,000 2.6 1.2 3.5 1.4 6.3 3.8 4.3 2.3 5.8 3.2 8.7 5.5 11.2 "
    "7.4 7.9 0.6 2.5 30.4 4 5 35 20",
}
# A number with a point, a comma or a unit looks like a result.
RESULT = re.compile(
    r"(?<![\w.,:/-])-?(?:\d+\.\d+|\d{1,3},\d{3}|\d+(?= (?:%|s|min|h|hours|minutes|points|GiB|frames/s)\b))"
)


def told(text):
    """Return the text without code, links, and numbers that name their source."""
    for pattern in (FENCE, fill._BLOCK, fill._NUMBER, re.compile(r"`[^`]*`"), re.compile(r"\]\([^)]*\)")):
        text = pattern.sub(" ", text)
    return text


@pytest.mark.parametrize("page", fill.PAGES)
def test_numbers_match_the_result_files(page):
    changed = subprocess.run(
        ["git", "status", "--porcelain", "reports"], cwd=ROOT, capture_output=True, text=True, check=False
    )
    if changed.stdout:
        pytest.skip("reports/ has results of other data or settings than those in git")
    assert fill.fill(PAGES[page]) == PAGES[page], "run `python docs/fill.py`"


@pytest.mark.parametrize("page", fill.PAGES)
def test_every_result_names_its_file(page):
    found = [
        number for number in RESULT.findall(told(PAGES[page])) if number not in GIVEN.get(page, "").split()
    ]
    assert found == [], "name the file as docs/fill.py says, or say in GIVEN that it is no result"


def test_outdated_numbers_are_corrected():
    text = '1.00<!-- = table("table_26", ALL, "HMM") --> and 99<!-- = verdicts("holds") -->'
    first, second = fill._NUMBER.findall(fill.fill(text))
    assert first[0] == f"{fill.table('table_26', fill.ALL, 'HMM'):.2f}" != "1.00"
    assert second[0] != "99"


def test_the_readme_is_short():
    assert len(PAGES["README.md"].splitlines()) <= 160


def test_there_is_one_version():
    assert "version" in tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]["dynamic"]
    assert yaml.safe_load((ROOT / "CITATION.cff").read_text())["version"] == placecat.__version__
    assert f"\n## {placecat.__version__} " in (ROOT / "CHANGELOG.md").read_text()


def test_the_public_checks_run_every_supported_python():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    versions = re.findall(r"Python :: (3\.\d+)", " ".join(project["classifiers"]))
    job = yaml.safe_load((ROOT / ".github/workflows/ci.yml").read_text())["jobs"]["test"]
    assert job["strategy"]["matrix"]["python"] == versions
    assert {"run": ".ci/run"} in job["steps"]
    low, high = (int(one) for one in re.findall(r"3\.(\d+)", project["requires-python"]))
    assert versions == [f"3.{minor}" for minor in range(low, high)]


def test_the_devcontainer_runs_a_target_of_make():
    opened = json.loads((ROOT / ".devcontainer/devcontainer.json").read_text())
    assert opened["postCreateCommand"].startswith("make ")


def test_make_help_names_every_target_in_one_line():
    targets = re.search(r"^\.PHONY: (help .*)$", MAKEFILE, re.MULTILINE)[1].split()
    # Within `make test`, make would also print the folder that it enters.
    for command in (["make", "--no-print-directory", "help"], ["make", "--no-print-directory"]):
        shown = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True).stdout
        assert sorted(line.split()[1] for line in shown.splitlines()) == sorted(targets)
        assert all(len(line.split(maxsplit=2)) == 3 for line in shown.splitlines())


def anchors(text):
    titles = re.findall(r"^#+ (.+)$", FENCE.sub("", text), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-") for title in titles}


@pytest.mark.parametrize("page", PAGES)
def test_links_have_targets(page):
    for link in re.findall(r"\]\(([^)\s]+)\)", FENCE.sub("", PAGES[page])):
        if "://" in link:
            continue
        name, _, anchor = link.partition("#")
        target = (ROOT / page).parent / name if name else ROOT / page
        assert target.exists(), link
        if anchor:
            assert anchor in anchors(target.read_text(encoding="utf-8")), link


@pytest.mark.slow
def test_the_site_is_built_without_a_warning_and_loads_nothing(tmp_path):
    pytest.importorskip("sphinx")
    trees, site = tmp_path / "doctrees", tmp_path / "site"
    build = ("sphinx", "-q", "-W", "--keep-going", "-c", "docs", "-d", trees, ".", site)
    subprocess.run([sys.executable, "-m", *build], cwd=ROOT, check=True)
    pages = list(site.rglob("*.html"))
    assert {page.stem for page in pages} >= {"index", "method", "security", "CONTRIBUTING"}
    for page in pages:
        assert re.findall(r"<(?:script|img|link)[^>]*(?:src|href)=\"https?:", page.read_text()) == []
