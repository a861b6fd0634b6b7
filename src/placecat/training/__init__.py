"""Training plans (which homes and frames train what), and training and applying a system by a plan."""
