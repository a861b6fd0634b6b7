"""Logging to MLflow: tables, rows, figures, findings and experiments."""
