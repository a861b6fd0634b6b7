"""The choice, on training homes, of settings that the thesis leaves open."""
