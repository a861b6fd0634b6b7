"""Descriptors of salient regions (thesis 3.1.2), one module per descriptor.

To add a descriptor, add a module named after it. The module defines a function ``describe(maps, regions, *,
settings...)`` that returns (n, D) float32. Its ``MAPS`` are the fields of `FrameMaps` that the function
reads. Its ``SPREAD`` is the descriptor's total standard deviation over regions in indoor frames, rounded.
`placecat.cues.cue_input` divides by ``SPREAD`` when joining descriptors.

In every module, `maps` are the frame's maps, and `regions` is (n, 4) float32 with the columns x, y (in frame
pixels), scale and strength. `border` is passed to `placecat.vision.patches.cut`, which raises PlacecatError
if the border is unknown.
"""
