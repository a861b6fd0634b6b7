"""Trained systems that name the place in each frame of new footage."""

from placecat.categorizer.categorizer import Categorizer, Decision
from placecat.categorizer.visits import Visit

__all__ = ["Categorizer", "Decision", "Visit"]
