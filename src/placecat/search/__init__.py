"""Searching the settings of an experiment with Optuna, judged on training homes only."""
