"""Seeds derived from what is computed, not from order or time."""

import hashlib


def derive(*parts: str | int) -> int:
    """Derive a seed from the names of what is computed.

    Parameters
    ----------
    *parts
        Anything that names the computation, e.g. ``("codebook", "hog_y", "Home1+Home2")``. Order matters.

    Returns
    -------
    int
        In [0, 2**32), the same on every machine.
    """
    text = "\x1f".join(f"{type(part).__name__}:{part}" for part in parts)
    return int.from_bytes(hashlib.sha256(text.encode()).digest()[:4], "big")
