"""``placecat explain``: find a number, print where it comes from, and recompute it."""
