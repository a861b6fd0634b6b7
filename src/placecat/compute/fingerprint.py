"""A description of everything that can change results: code, versions, kernels, processor."""

import hashlib
import importlib.util
import platform
from functools import cache
from importlib import metadata
from pathlib import Path

import placecat

# Packages that compute results.
PACKAGES = ("numpy", "scipy", "scikit-learn", "pandas", "joblib")
# It pickles tasks and results on a cluster, and is not always installed.
_CLUSTER = "distributed"


@cache
def fingerprint() -> dict[str, str]:
    """Describe the environment of this process, one string per item.

    The description is computed once per process, since later changes to files do not affect modules already
    loaded. ``placecat`` includes a digest of the code. ``BLAS`` lists the kernels chosen by NumPy, SciPy and
    OpenCV, and ``processor`` lists the vector instructions used by NumPy and OpenCV.
    """
    # Imported late: OpenCV is not needed to read PACKAGES.
    import cv2
    import numpy as np
    import scipy.linalg  # noqa: F401  loads SciPy's BLAS
    from threadpoolctl import threadpool_info

    blas = {
        f"{one['internal_api']} {one['version']} {one.get('architecture', '')}".strip()
        for one in threadpool_info()
        if one["user_api"] == "blas"
    }
    vectors = np.show_config(mode="dicts")["SIMD Extensions"]
    return {
        "placecat": f"{metadata.version('placecat')}, code {_digest(Path(placecat.__file__).parent)}",
        "Python": ".".join(platform.python_version_tuple()[:2]),
        **{name: metadata.version(name) for name in (*PACKAGES, *_installed(_CLUSTER))},
        "OpenCV": cv2.__version__,
        "BLAS": ", ".join(sorted(blas)),
        "processor": f"{platform.machine()}; NumPy {' '.join(vectors['found']) or 'baseline'}; "
        f"OpenCV {_used(cv2.getCPUFeaturesLine())}",
        "C library": " ".join(platform.libc_ver()).strip() or platform.system(),
    }


def _installed(package: str) -> tuple[str, ...]:
    return (package,) if importlib.util.find_spec(package) is not None else ()


def _digest(folder: Path) -> str:
    """Return a digest of all modules in a folder as eight hexadecimal digits."""
    digest = hashlib.sha256()
    for path in sorted(folder.rglob("*.py")):
        digest.update(f"{path.relative_to(folder).as_posix()}\0".encode())
        digest.update(path.read_bytes())
    return digest.hexdigest()[:8]


def _used(features: str) -> str:
    """Return the vector instructions in OpenCV's list that this processor supports.

    OpenCV marks unsupported instructions with a "?".
    """
    dispatched = [name[1:] for name in features.split() if name.startswith("*")]
    return " ".join(name for name in dispatched if not name.endswith("?")) or "baseline"
