"""Judge candidates on training homes to choose the settings that the thesis leaves open."""
