"""Name the places in new footage frame by frame, with a trained system."""

from placecat.categorizer.categorizer import Categorizer, Decision
from placecat.categorizer.visits import Visit

__all__ = ["Categorizer", "Decision", "Visit"]
