"""Plan which frames to train a system on, and train and apply systems according to these plans."""
