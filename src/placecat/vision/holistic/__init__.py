"""Holistic descriptors of a frame (thesis 3.2), each in a module of its own.

To add a descriptor, add a module with its name. The module has a function
``describe(frame, maps, *, settings...)``, which returns (D,) float32, and ``MAPS``, the fields of `FrameMaps`
that the function reads. If it needs packages from an extra, it imports them in ``describe`` and lists them in
``PACKAGES``. Tests skip the descriptor if these packages are missing.
"""
