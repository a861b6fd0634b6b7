"""Choose the settings that the thesis leaves open, by judging candidates on training homes."""
