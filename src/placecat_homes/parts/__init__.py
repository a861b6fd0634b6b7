"""Parts that several kinds of furniture share."""
