"""From a frame to its salient regions and descriptors. Knows nothing of labels or files."""
