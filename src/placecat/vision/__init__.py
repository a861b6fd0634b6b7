"""From a frame to its salient regions and descriptors. This package knows no labels and opens no files."""
