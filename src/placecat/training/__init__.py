"""Training: plans of who trains on which frames, and the one way to train and apply a system by a plan."""
