"""Search for the best settings of an experiment with Optuna, judging them on training homes only."""
