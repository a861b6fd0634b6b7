"""Apply a trained system to new footage: tables, a timeline and an annotated video (``placecat predict``)."""
