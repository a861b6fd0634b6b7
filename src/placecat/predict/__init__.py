"""A trained system on new footage: tables, a timeline and an annotated video (``placecat predict``)."""
