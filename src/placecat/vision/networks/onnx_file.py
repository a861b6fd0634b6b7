"""Run networks stored in ONNX files with onnxruntime."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from placecat.errors import PlacecatError, reading
from placecat.vision.networks import onnx_content
from placecat.vision.networks.packages import import_packages

PACKAGES = ("onnxruntime",)
CHANNELS = 3


def load(
    path: Path, output: str | None = None, sha256: str | None = None
) -> Callable[[NDArray[np.float32]], NDArray[np.float32]]:
    """Load the network in an ONNX file and return a function that applies it to an image.

    The network must have exactly one input, a (1, 3, height, width) float32 image. `output` is the name of
    the output to use, or None for the first output. `sha256` is the expected checksum (see
    `onnx_content.fingerprint`), or None to accept any. The function maps a (1, 3, H, W) float32 image to the
    output, which is float32 of any shape.

    Raises
    ------
    PlacecatError
        If onnxruntime or the file is missing, if `onnx_content.check` rejects the file, if it is not an ONNX
        file, or if the network does not take exactly one image or lacks the requested output. The returned
        function raises this error if it cannot process an image, for example because of its size.
    """
    with reading(path):
        is_there = path.is_file()
    if not is_there:
        raise PlacecatError(
            f"the network {path} named in the settings is missing: add the file, or choose another network"
        )
    onnx_content.check(path, sha256)
    (onnxruntime,) = import_packages(PACKAGES, f"the network {path}")
    options = onnxruntime.SessionOptions()
    options.intra_op_num_threads = options.inter_op_num_threads = 1
    options.use_deterministic_compute = True
    # Log only fatal errors. All other errors are raised, and each is reported as one message.
    options.log_severity_level = 4
    try:
        session = onnxruntime.InferenceSession(path, options, providers=["CPUExecutionProvider"])
    # The errors raised by onnxruntime have no common base class.
    except Exception as error:
        raise PlacecatError(f"{path} is not an ONNX file that onnxruntime can run: {_short(error)}") from None
    name = _input(session, path)
    outputs = [one.name for one in session.get_outputs()]
    wanted = outputs[0] if output is None else output
    if wanted not in outputs:
        raise PlacecatError(f"{path} has no output {wanted!r}: choose one of {', '.join(outputs)}")

    def apply(image: NDArray[np.float32]) -> NDArray[np.float32]:
        try:
            (values,) = session.run([wanted], {name: image})
        except Exception as error:
            size = "x".join(map(str, image.shape[:1:-1]))
            raise PlacecatError(
                f"{path} cannot process an image of {size} pixels; set width and height. {_short(error)}"
            ) from None
        return np.asarray(values, np.float32)

    return apply


def _input(session: Any, path: Path) -> str:
    """Return the name of the single input, which must accept an image."""
    inputs = session.get_inputs()
    kinds = [f"{one.type.removeprefix('tensor')} {one.shape}" for one in inputs]
    if len(inputs) != 1 or inputs[0].type != "tensor(float)" or not _takes_image(inputs[0].shape):
        raise PlacecatError(
            f"{path} has the input {', '.join(kinds) or '(none)'}: choose a network with one image as input, "
            f"(float) [1, {CHANNELS}, height, width]"
        )
    return str(inputs[0].name)


def _takes_image(shape: list[int | str | None]) -> bool:
    # A dimension without a fixed size is a string or None.
    return len(shape) == 4 and all(
        not isinstance(found, int) or found == wanted
        for found, wanted in zip(shape[:2], (1, CHANNELS), strict=True)
    )


def _short(error: Exception) -> str:
    said = " ".join(str(error).split())
    return said if len(said) <= 200 else f"{said[:200]}..."
