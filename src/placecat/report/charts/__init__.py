"""Charts of tables for MLflow, in the figures' style."""
