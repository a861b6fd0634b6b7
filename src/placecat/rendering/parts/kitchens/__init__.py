"""Parts of fitted kitchens."""
