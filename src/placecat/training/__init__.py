"""Plan which frames train a system; train systems and apply them according to such plans."""
