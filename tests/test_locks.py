"""The two lists of pinned packages: one to run with, one to test and to render with."""

import re
import tomllib

import pytest

from project import ROOT

LOCKS = ("requirements.lock", "requirements-test.lock")


def pinned(lock):
    """Each pinned package, with its condition, to the hashes of its files."""
    blocks = re.split(r"\n(?=\S)", (ROOT / lock).read_text())
    return {block.split(" \\")[0]: set(re.findall(r"--hash=(\S+)", block)) for block in blocks}


def names(lines):
    return {re.sub(r"[-_.]+", "-", re.match(r"[\w.-]+", line)[0].lower()) for line in lines}


def test_what_runs_is_pinned_alike_for_the_tests():
    run, test = map(pinned, LOCKS)
    assert len(run) > 100
    assert run.items() <= test.items()


def test_what_runs_needs_no_extra():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    extras = project["optional-dependencies"]
    run, test = (names(pinned(lock)) for lock in LOCKS)
    assert names(project["dependencies"] + extras["build"]) <= run
    further = names(extra for name in ("cluster", "render", "search", "test") for extra in extras[name])
    assert further <= test
    assert not further & run


@pytest.mark.parametrize("lock", LOCKS)
def test_everything_is_pinned_by_hash_and_no_address_is_given(lock):
    assert all("==" in name and hashes for name, hashes in pinned(lock).items())
    text = (ROOT / lock).read_text()
    assert "://" not in text
    assert not re.search(r"^\s*(-i|-f|--index-url|--extra-index-url|--find-links)\b", text, re.M)


@pytest.mark.xdist_group("together")
def test_tests_of_a_group_stay_together(request):
    """pytest-xdist tells groups by the end of a test's name; another pytest may not let it."""
    if not getattr(request.config.option, "loadgroup", False):
        pytest.skip("without --dist loadgroup")
    assert request.node.nodeid.endswith("@together")
