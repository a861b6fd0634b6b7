"""The look of all charts and figures: one style, one palette."""
