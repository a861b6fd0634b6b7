"""The thesis beside a run's measurements: tables, findings, numbers in the text."""
