"""From the cues' distributions to one decision: integration and smoothing."""
