"""Training plans, and the training and application of systems according to them."""
