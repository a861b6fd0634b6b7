"""Places of new footage, frame by frame, by a trained system."""

from placecat.categorizer.categorizer import Categorizer, Decision

__all__ = ["Categorizer", "Decision"]
