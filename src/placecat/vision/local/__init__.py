"""Descriptors of salient regions (thesis 3.1.2), each in a module of its own.

To add a descriptor, add a module with its name. The module has a function
``describe(maps, regions, *, settings...)``, which returns (n, D) float32, and ``MAPS``, the fields of
`FrameMaps` that the function reads. It also has ``SPREAD``, the rounded total standard deviation over regions
in indoor frames. `placecat.cues.cue_input` divides by ``SPREAD`` when it joins descriptors.

In every module, `maps` are the frame's maps, and `regions` is (n, 4) float32 with the columns x, y
(in frame pixels), scale and strength. `border` is passed to `placecat.vision.patches.cut`, and errors that
this function raises are passed on.
"""
