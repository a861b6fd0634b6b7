"""``placecat predict`` applies a trained system to footage and writes tables, a timeline and a video."""
