"""A page that shows two runs side by side."""
