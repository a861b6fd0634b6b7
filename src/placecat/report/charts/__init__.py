"""Charts of tables for MLflow, in the style of the figures."""
