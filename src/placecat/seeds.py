"""Derive seeds from names, independently of call order and time."""

import hashlib


def derive(*parts: str | int) -> int:
    """Derive a seed in [0, 2**32) from names such as ``("codebook", "hog_y", "Home1+Home2")``."""
    text = "\x1f".join(f"{type(part).__name__}:{part}" for part in parts)
    return int.from_bytes(hashlib.sha256(text.encode()).digest()[:4], "big")
