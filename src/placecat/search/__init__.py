"""Search an experiment's settings with Optuna, judged on training homes only."""
