"""Choose settings that the thesis leaves open, on training homes."""
