"""The common style and colours of all charts and figures."""
