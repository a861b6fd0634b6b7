"""Choose the settings that the thesis leaves open, judging them on training homes."""
