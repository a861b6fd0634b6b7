"""Descriptors of salient regions (thesis 3.1.2), one module each.

To add a descriptor, add a module with its name. The module has ``describe(maps, regions, *, settings...)``,
which returns (n, D) float32; ``MAPS``, the fields of `FrameMaps` that it reads; and ``SPREAD``, the total
standard deviation over regions in indoor frames, rounded: `placecat.cues.cue_input` divides by it when it
joins descriptors.

In every module, `maps` are the frame's maps and `regions` is (n, 4) float32: x, y (frame pixels), scale and
strength. `border` is passed to `placecat.vision.patches.cut`, whose errors are raised.
"""
