"""Training: a plan of who trains what on which frames, and the one way to train and apply a system by it."""
