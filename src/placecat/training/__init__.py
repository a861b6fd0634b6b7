"""Training plans, and training and application of systems by a plan."""
