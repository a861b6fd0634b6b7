"""A one-minute demo: train a system on five homes, then walk through a sixth home."""
