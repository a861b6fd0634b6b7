"""A demo of one minute: train a system on five homes, then walk through a sixth."""
