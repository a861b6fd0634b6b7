"""From measured numbers to tables, the page and MLflow."""
