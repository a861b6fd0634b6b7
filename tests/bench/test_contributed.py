import numpy as np
import pytest

from placecat.errors import PlacecatError
from placecat_bench import contributed

PICTURE = np.random.default_rng(0).integers(0, 256, (60, 80, 3)).astype(np.uint8)
NAME = "StaticSaliencySpectralResidual"


def test_contributed_opencv_runs_in_a_separate_process(tmp_path, monkeypatch):
    """The package is replaced with one that records its images."""
    (tmp_path / "cv2.py").write_text(
        "def setNumThreads(number): ...\n"
        "class saliency:\n"
        "    class StaticSaliencySpectralResidual_create:\n"
        "        def computeSaliency(self, image):\n"
        f"            with open({str(tmp_path / 'log')!r}, 'a') as log:\n"
        "                print(image.shape, file=log)\n"
    )
    monkeypatch.setattr(contributed, "FOLDER", tmp_path)
    with contributed.contributed(NAME, [PICTURE, PICTURE[:30]]) as compute:
        compute()
        compute()
    assert (tmp_path / "log").read_text().splitlines() == ["(60, 80, 3)", "(30, 80, 3)"] * 2


def test_a_missing_package_raises_an_error_with_a_remedy(tmp_path, monkeypatch, capfd):
    (tmp_path / "cv2.py").write_text("raise ImportError")
    monkeypatch.setattr(contributed, "FOLDER", tmp_path)
    with (
        contributed.contributed(NAME, [PICTURE]) as compute,
        pytest.raises(PlacecatError, match=r"does not work: run `make bench`"),
    ):
        compute()
