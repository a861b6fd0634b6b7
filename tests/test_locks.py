"""The lock files for running, for tests and rendering, and for `make bench`."""

import re
import tomllib

import pytest

from project import ROOT

LOCKS = ("requirements.lock", "requirements-test.lock", "requirements-bench.lock")


def pinned(lock):
    """Map each pinned package, with its condition, to the hashes of its files."""
    blocks = re.split(r"\n(?=\S)", (ROOT / lock).read_text())
    return {block.split(" \\")[0]: set(re.findall(r"--hash=(\S+)", block)) for block in blocks}


def names(lines):
    return {re.sub(r"[-_.]+", "-", re.match(r"[\w.-]+", line)[0].lower()) for line in lines}


def test_each_lock_is_part_of_the_next():
    run, test, bench = map(pinned, LOCKS)
    assert len(run) > 100
    assert run.items() <= test.items() <= bench.items()


def test_each_lock_has_its_extras_and_no_others():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    extras = {name: names(packages) for name, packages in project["optional-dependencies"].items()}
    run, test, bench = (names(pinned(lock)) for lock in LOCKS)
    assert names(project["dependencies"]) | extras["build"] <= run
    others = ("bench", "bench-torch", "build", "deep")
    tested = set().union(*(packages for name, packages in extras.items() if name not in others))
    assert tested <= test
    assert not tested & run
    assert extras["bench"] <= bench
    assert extras["bench"] & test == extras["bench"] & tested
    assert not (extras["deep"] | extras["bench-torch"]) & bench


def test_peers_need_no_deep_learning_framework():
    assert not {"torch", "tensorflow", "jax"} & names(pinned("requirements-bench.lock"))


@pytest.mark.parametrize("lock", LOCKS)
def test_every_python_has_the_same_version_of_a_package(lock):
    """Otherwise, results could differ between versions of Python, and only one of these is tested."""
    packages = [line.partition("==")[0] for line in pinned(lock)]
    assert len(packages) == len(set(packages))


@pytest.mark.parametrize("lock", LOCKS)
def test_everything_is_pinned_by_hash_and_no_address_is_given(lock):
    assert all("==" in name and hashes for name, hashes in pinned(lock).items())
    text = (ROOT / lock).read_text()
    assert "://" not in text
    assert not re.search(r"^\s*(-i|-f|--index-url|--extra-index-url|--find-links)\b", text, re.M)


@pytest.mark.xdist_group("together")
def test_tests_of_a_group_stay_together(request):
    """This may fail with another pytest, since pytest-xdist recognizes groups by the end of a test name."""
    if not getattr(request.config.option, "loadgroup", False):
        pytest.skip("without --dist loadgroup")
    assert request.node.nodeid.endswith("@together")
