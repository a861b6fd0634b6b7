"""``placecat predict``: apply a trained system to footage; write tables, a timeline and a video."""
