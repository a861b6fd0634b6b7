"""Plan which frames train a system, and train and apply systems according to these plans."""
