"""Tests of ONNX files that are rejected before they run, and of the checksum."""

import hashlib
import shutil
import subprocess

import numpy as np
import onnx_bytes
import pytest
from onnx_bytes import field, mean_color, model, node, scaled_mean_color, subgraph

from placecat.errors import PlacecatError
from placecat.vision.networks import onnx_content

LOOP = node("Loop", ["n", "yes"], "out", subgraph("body", node("Identity", ["yes"], "still")))
RANDOM = node("RandomNormalLike", ["image"], "noise")


@pytest.fixture
def path(tmp_path):
    return tmp_path / "net.onnx"


def refused(message, path, sha256=None):
    with pytest.raises(PlacecatError, match=message) as caught:
        onnx_content.check(path, sha256)
    assert "\n" not in str(caught.value) and path.name in str(caught.value)


def graph(*nodes):
    return model(nodes, [], [])


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (graph(RANDOM), "operator RandomNormalLike, which is random"),
        *(
            (graph(node(kind, [], "noise")), f"operator {kind}, which is random")
            for kind in ("RandomNormal", "RandomUniform", "Multinomial", "Bernoulli", "Sampling")
        ),
        (graph(node("Dropout", ["image", "ratio", "yes"], "noise")), "operator Dropout, which is random"),
        (graph(LOOP), "operator Loop, which may never terminate"),
        # The loop is inside a branch of a branch.
        (
            graph(node("If", ["yes"], "out", subgraph("a", node("If", ["no"], "out", subgraph("b", LOOP))))),
            "Loop",
        ),
        # The operator is inside a function that the file defines.
        (mean_color() + field(25, field(1, "mine") + field(7, RANDOM)), "RandomNormalLike"),
    ],
)
def test_random_and_endless_operators_are_refused(path, content, message):
    path.write_bytes(content)
    refused(message, path)


def test_usual_networks_are_taken(path):
    path.write_bytes(mean_color())
    onnx_content.check(path, None)
    # Exporters write Dropout like this for inference.
    path.write_bytes(
        graph(node("Dropout", ["image", "ratio", ""], "same"), node("Dropout", ["image"], "also"))
    )
    onnx_content.check(path, None)


def test_the_checksum_covers_weights_in_other_files(path):
    path.write_bytes(mean_color())
    assert onnx_content.fingerprint(path, []) == hashlib.sha256(path.read_bytes()).hexdigest()
    path.write_bytes(scaled_mean_color("weights.bin"))
    weights = path.with_name("weights.bin")
    weights.write_bytes(np.ones(3, np.float32).tobytes())
    expected = onnx_content.fingerprint(path, [weights])
    onnx_content.check(path, expected)
    weights.write_bytes(np.zeros(3, np.float32).tobytes())
    refused("it is not the expected file", path, expected)


@pytest.mark.skipif(shutil.which("sha256sum") is None, reason="there is no sha256sum")
def test_the_checksum_equals_the_shell(path):
    path.write_bytes(mean_color())
    path.with_name("a.bin").write_bytes(b"weights")
    shell = "sha256sum net.onnx a.bin | sha256sum"
    said = subprocess.run(
        shell, shell=True, cwd=path.parent, capture_output=True, text=True, check=True
    ).stdout
    assert onnx_content.fingerprint(path, [path.with_name("a.bin")]) == said.split()[0]


@pytest.mark.parametrize("location", ["/etc/passwd", "../secret", "a/../../secret", "", "a\\b"])
def test_weights_outside_the_folder_are_refused(path, location):
    path.write_bytes(scaled_mean_color(location))
    refused("outside its folder", path)


def test_missing_and_linked_weights_are_refused(path, tmp_path):
    path.write_bytes(scaled_mean_color("weights.bin"))
    refused(r"weights\.bin, which holds the weights of net\.onnx, is missing", path)
    path.with_name("weights.bin").symlink_to(onnx_bytes.__file__)
    refused("links to a file outside the folder: replace it with a copy", path)


def test_damaged_files_give_one_message(path):
    content = scaled_mean_color("weights.bin")
    path.with_name("weights.bin").write_bytes(bytes(12))
    for end in (0, 1, 7, len(content) // 2, len(content) - 1):
        path.write_bytes(content[:end])
        refused("is not an ONNX file", path)
    for seed in range(200):
        rng = np.random.default_rng(seed)
        damaged = bytearray(content)
        damaged[rng.integers(len(damaged))] = rng.integers(256)
        path.write_bytes(damaged)
        try:
            onnx_content.check(path, None)
        except PlacecatError as error:
            assert "\n" not in str(error)


def test_graphs_within_graphs_are_followed_to_any_depth(path):
    inner = RANDOM
    for _ in range(3000):
        inner = node("If", ["yes"], "out", subgraph("branch", inner))
    path.write_bytes(graph(inner))
    refused("RandomNormalLike", path)


def test_a_file_that_may_not_be_read_gives_one_message(path, monkeypatch):
    def refuse(*_):
        raise PermissionError(13, "Permission denied", str(path))

    path.write_bytes(mean_color())
    monkeypatch.setattr("pathlib.Path.open", refuse)
    refused(r"net\.onnx cannot be read: Permission denied", path)
