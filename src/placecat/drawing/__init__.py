"""The common style and palette of all charts and figures."""
