"""Tests of ONNX files with a stand-in for onnxruntime, and with onnxruntime itself if it is installed."""

import sys
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import onnx_bytes
import pytest
from makers import frame

from placecat.errors import PlacecatError
from placecat.vision import networks
from placecat.vision.holistic import embedding
from placecat.vision.networks import onnx_file

IMAGE = np.random.default_rng(0).normal(size=(1, 3, 4, 6)).astype(np.float32)
TAKES = ("tensor(float)", ["batch", 3, "height", "width"])


def stand_in(monkeypatch, *, inputs=(TAKES,), outputs=("vector", "places"), run=None, broken=False):
    """Replace onnxruntime with a fake module, and return the list of its sessions."""
    sessions = []

    class Session:
        def __init__(self, path, options, providers):
            if broken:
                raise RuntimeError("Load model failed:\n  Protobuf parsing failed.")
            self.options, self.providers = options, providers
            sessions.append(self)

        def get_inputs(self):
            return [SimpleNamespace(name="image", type=kind, shape=shape) for kind, shape in inputs]

        def get_outputs(self):
            return [SimpleNamespace(name=name) for name in outputs]

        def run(self, wanted, fed):
            assert set(fed) == {"image"}
            return [run(wanted[0], fed["image"])]

    module = SimpleNamespace(SessionOptions=SimpleNamespace, InferenceSession=Session)
    monkeypatch.setitem(sys.modules, "onnxruntime", module)
    return sessions


@pytest.fixture
def file(tmp_path):
    path = tmp_path / "net.onnx"
    path.write_bytes(onnx_bytes.mean_color())
    return path


def one_message(match, function, *arguments):
    with pytest.raises(PlacecatError, match=match) as caught:
        function(*arguments)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(("output", "taken"), [(None, "vector"), ("places", "places")])
def test_the_named_output_is_taken_in_one_thread(monkeypatch, file, output, taken):
    asked = []

    def run(name, image):
        asked.append(name)
        return image.mean(axis=(2, 3), dtype=np.float64)

    sessions = stand_in(monkeypatch, run=run)
    found = onnx_file.load(file, output)(IMAGE)
    assert asked == [taken]
    assert found.dtype == np.float32
    np.testing.assert_allclose(found, IMAGE.mean(axis=(2, 3)), rtol=1e-6)
    options = sessions[0].options
    assert (options.intra_op_num_threads, options.inter_op_num_threads) == (1, 1)
    assert sessions[0].providers == ["CPUExecutionProvider"]


def test_a_missing_file_and_one_with_another_checksum_are_named(file):
    one_message(r"nowhere\.onnx named in the settings is missing", onnx_file.load, Path("nowhere.onnx"))
    one_message("it is not the expected file", onnx_file.load, file, None, "0" * 64)


def test_without_onnxruntime_the_message_says_how_to_install_it(monkeypatch, file):
    monkeypatch.setitem(sys.modules, "onnxruntime", None)
    one_message(r"needs the package onnxruntime, .* `pip install -e '\.\[deep\]'", onnx_file.load, file)


@pytest.mark.parametrize(
    ("inputs", "message"),
    [
        (
            [("tensor(float)", [1, 224, 224, 3])],
            r"has the input \(float\) \[1, 224, 224, 3\]: choose a network with one image",
        ),
        ([("tensor(float16)", [1, 3, 224, 224])], r"has the input \(float16\)"),
        ([("tensor(float)", [8, 3, "h", "w"])], r"has the input \(float\) \[8, 3"),
        ([("tensor(float)", [1, 3])], "choose a network with one image"),
        ([TAKES, TAKES], "choose a network with one image"),
        ([], r"has the input \(none\)"),
    ],
)
def test_a_network_of_something_else_than_an_image_is_refused(monkeypatch, file, inputs, message):
    stand_in(monkeypatch, inputs=inputs)
    one_message(message, onnx_file.load, file)


def test_messages_of_onnxruntime_become_one_line(monkeypatch, file):
    stand_in(monkeypatch, broken=True)
    one_message(r"net\.onnx is not an ONNX file .*: Load model failed: Protobuf", onnx_file.load, file)

    def refuse(name, image):
        raise RuntimeError("Got invalid dimensions for input: image")

    stand_in(monkeypatch, run=refuse)
    one_message(r"an image of 6x4 pixels; set width and height\. Got invalid", onnx_file.load(file), IMAGE)
    one_message("no output 'feature': choose one of vector, places", onnx_file.load, file, "feature")


@pytest.fixture
def real(file):
    pytest.importorskip("onnxruntime", reason="onnxruntime, from the `deep` extra, is not installed")
    return str(file)


def test_a_real_file_describes_a_frame(real):
    picture = frame(64, 48)
    found = embedding.describe(picture, None, network=real, width=64, height=48)
    own = networks.preparation(real)
    expected = (picture[:, :, ::-1].mean(axis=(0, 1)) / 255 - np.array(own.mean)) / own.std
    np.testing.assert_allclose(found, expected, atol=1e-5)
    pooled = embedding.describe(
        picture, None, network=real, width=64, height=48, output="places", pool="mean"
    )
    np.testing.assert_allclose(pooled, found, atol=1e-5)


def test_mistakes_with_a_real_file_give_one_message(real, tmp_path):
    one_message(
        r"returns an array of shape \(3, 224, 224\) for a frame, not a vector: set pool to mean",
        lambda: embedding.describe(frame(), None, network=real, output="places"),
    )
    fixed = tmp_path / "fixed.onnx"
    fixed.write_bytes(onnx_bytes.mean_color(32, 48))
    one_message(
        "image of 224x224 pixels; set width and height",
        lambda: embedding.describe(frame(), None, network=str(fixed)),
    )
    fixed.write_bytes(b"no network")
    networks.load.cache_clear()
    one_message("is not an ONNX file", lambda: embedding.describe(frame(), None, network=str(fixed)))


def test_a_real_file_with_weights_elsewhere_describes_a_frame(real, tmp_path):
    path = tmp_path / "scaled.onnx"
    path.write_bytes(onnx_bytes.scaled_mean_color("weights.bin"))
    (tmp_path / "weights.bin").write_bytes(np.array([1, 2, 3], np.float32).tobytes())
    np.testing.assert_allclose(
        onnx_file.load(path)(IMAGE)[0], IMAGE.mean(axis=(0, 2, 3)) * [1, 2, 3], rtol=1e-5
    )
