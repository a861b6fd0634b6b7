"""Settings that the thesis leaves open, chosen on training homes."""
