"""Holistic descriptors of a frame (thesis 3.2), one module per descriptor.

To add a descriptor, add a module named after it. The module defines a function ``describe(frame, maps, *,
settings...)`` that returns (D,) float32. Its ``MAPS`` are the fields of `FrameMaps` that the function reads.
If it needs packages from an extra, it imports them inside ``describe`` and lists them in ``PACKAGES``. Tests
skip the descriptor if these packages are missing.
"""
