"""Search for an experiment's best settings with Optuna, judging them on training homes only."""
