"""Charts of tables for MLflow, in the same style as the figures."""
