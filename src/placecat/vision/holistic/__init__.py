"""Holistic frame descriptors (thesis 3.2), one module each.

To add a descriptor, add a module with its name. The module has ``describe(frame, maps, *, settings...)``,
which returns (D,) float32, and ``MAPS``, the fields of `FrameMaps` that it reads. If it needs packages from
an extra, it imports them in ``describe`` and lists them in ``PACKAGES``; tests skip it if they are missing.
"""
